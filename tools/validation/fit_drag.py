"""Fits C_p of front and back, and the bluntness that counts as blunt, to the tabulated drag of blunt
and slender bodies, and prints the optimum beside the default:

    /usr/bin/python3 -B tools/validation/fit_drag.py
"""

from __future__ import annotations

import numpy as np

from drag_bodies import DragBody, kBodies, kDefault, Law, slenderness

kSpeeds = (0.5, 2.0, 8.0)  # [m/s]
kSizes = (0.3, 1.0, 3.0)  # Diameters [m].
kSlenderFactor = 1.27  # What a slender body exceeds of it counts three times over.


class Table:
    """Everything that the objective needs of the bodies."""

    def __init__(self, bodies: list[DragBody] = kBodies):
        cases = [(speed, size) for size in kSizes for speed in kSpeeds]
        self.slender = np.array([body.slender for body in bodies])
        self.bluntness = np.array([body.bluntness for body in bodies]).T
        self.normals = np.array([body.normal_integrals() for body in bodies])
        self.friction = np.array([[body.friction(kDefault, *case) for case in cases]
                                  for body in bodies])
        self.reference = np.array([[body.reference(*case) for case in cases] for body in bodies])

    def ratios(self, law: Law) -> np.ndarray:
        """C_d over the tabulated one, a row a body."""
        pressure = slenderness(*self.bluntness, law)**3 * (self.normals @ (law.front, law.back))
        return (pressure[:, None] + self.friction) / self.reference

    def objective(self, law: Law) -> float:
        """Mean of |log(C_d ours / C_d tabulated)|, and a penalty on slender bodies."""
        logs = np.abs(np.log(self.ratios(law)))
        excess = np.maximum(0, logs[self.slender] - np.log(kSlenderFactor))
        return float(np.mean(logs) + 3 * np.mean(excess))


def fit_drag(table: Table, spacing: float = 0.02) -> Law:
    """The best law of a grid."""
    def values(low: float, high: float):
        return np.arange(low, high + spacing / 2, spacing)
    laws = [Law(front, back, blunt) for front in values(0.5, 1) for back in values(0.1, 0.5)
            for blunt in values(0.24, 0.5)]
    return min(laws, key=table.objective)


def main() -> None:
    table = Table()
    for title, law in (("best of the grid", fit_drag(table)), ("default", kDefault)):
        ratios = table.ratios(law)
        slender = np.exp(np.max(np.abs(np.log(ratios[table.slender]))))
        print(f"{title:17} front {law.front:.2f}, back {law.back:.2f}, blunt {law.blunt:.2f}: "
              f"objective {table.objective(law):.4f}, median error "
              f"{np.median(np.abs(ratios - 1)):.3f}, slender within {slender:.2f}")


if __name__ == "__main__":
    main()
