"""Rewrites linear_motions.csv, the motions of the floating bodies by linear theory:

    python3 tools/validation/linear_motions.py

It takes some minutes and needs SciPy. What `tools/validate` compares is the table; the program has
no part in it. On the hemisphere the panels give added mass, damping and excitation to 0.7 % of
WAMIT's (tests/validation/potential_flow_test.py).
"""

from __future__ import annotations

import csv

import numpy as np

from floating_bodies import kBodies, kDensity, kMotions, kTable
from potential_flow import barge, hemisphere, motions, solve, spar

kPanels = {"sphere": hemisphere(1, 12, 12), "barge": barge(20, 8, 1.5, (16, 8, 6)),
           "spar": spar(1, 10, 24, 8)}


def main() -> None:
    with open(kTable, "w", newline="", encoding="utf-8") as file:
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow(("body", "wavelength", "motion", "amplitude", "phase_deg"))
        for name, panels in kPanels.items():
            body = kBodies[name]
            for length in body.wavelengths:
                k = 2 * np.pi / length
                found = motions(solve(panels, k, body.inertia.centre, kDensity), body.inertia, k)
                for motion, one in zip(kMotions, found):
                    if motion in body.motions:  # Time goes as e^{-iωt} there.
                        lead = -np.degrees(np.angle(one))
                        lines.writerow((name, length, motion, f"{abs(one):.5f}", f"{lead:.2f}"))
                file.flush()


if __name__ == "__main__":
    main()
