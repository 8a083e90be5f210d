"""The panels that give the reference for motions in waves, against WAMIT and against identities."""

import importlib.util
import sys
import unittest
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[2] / "tools" / "validation"))

# WAMIT's hemisphere: kR, then of heave and surge the added mass and damping over ρV and ρVω, and
# the exciting force over ρgπR²a.
kHemisphere = ((0.1, (0.8624, 0.1813, 0.8779), (0.5223, 0.0011, 0.0964)),
               (0.5, (0.5862, 0.3388, 0.5366), (0.6436, 0.0988, 0.4090)),
               (1.0, (0.4284, 0.2484, 0.3247), (0.5739, 0.3532, 0.5476)))


@unittest.skipUnless(importlib.util.find_spec("scipy"), "needs python3-scipy")
class PotentialFlowTest(unittest.TestCase):
    def test_gives_the_coefficients_of_the_hemisphere(self):
        """The error goes as the size of panels: 3 % of 48, 0.7 % of the 144 of the reference."""
        from potential_flow import kHeave, kSurge, hemisphere, solve
        panels, volume, gravity = hemisphere(1, 6, 8), 2 / 3 * np.pi, 9.80665
        for k, heave, surge in kHemisphere:
            found = solve(panels, k, 0, 1)
            for mode, exact in ((kHeave, heave), (kSurge, surge)):
                ours = (found.added_mass[mode, mode] / volume,
                        found.damping[mode, mode] / volume / np.sqrt(gravity * k),
                        abs(found.excitation[mode]) / (gravity * np.pi))
                np.testing.assert_allclose(ours, exact, rtol=0.035, atol=1e-3)

    def test_radiates_what_its_damping_takes(self):
        """Haskind and Newman: B = k |X|² / (4 ρ g c_g) for heave of a body of revolution."""
        from potential_flow import kHeave, solve, spar
        k, gravity = 0.4, 9.80665
        found = solve(spar(1, 2, 10, 6), k, -1, 1)
        group = 0.5 * np.sqrt(gravity / k)
        radiated = k * abs(found.excitation[kHeave])**2 / (4 * gravity * group)
        self.assertAlmostEqual(found.damping[kHeave, kHeave] / radiated, 1, delta=0.02)

    def test_keeps_long_waves_from_moving_a_body_otherwise_than_its_water(self):
        from floating_bodies import kBodies
        from potential_flow import barge, motions, solve
        k, body = 2 * np.pi / 4000, kBodies["barge"]
        found = motions(solve(barge(20, 8, 1.5, (6, 4, 3)), k, 0, 1000), body.inertia, k)
        np.testing.assert_allclose(found, (1j, 1, -1j), atol=5e-3)


if __name__ == "__main__":
    unittest.main()
