"""The steady part of a response is found in motions that are made of known parts."""

import sys
import unittest
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[2] / "tools" / "seakeeping"))

from harmonics import response  # noqa: E402

kOmega = 2 * np.pi / 5


def times(periods: float) -> np.ndarray:
    return np.linspace(0, periods * 5, int(periods * 40) + 1)


class HarmonicsTest(unittest.TestCase):
    def test_finds_amplitude_and_lead_beside_drift_and_harmonics(self):
        t = times(20)
        x = 3 + 0.1 * t + 0.7 * np.cos(kOmega * t + 0.4) + 0.2 * np.cos(2 * kOmega * t)
        found = response(t, x, kOmega)
        self.assertAlmostEqual(abs(found.amplitude), 0.7, places=9)
        self.assertAlmostEqual(np.angle(found.amplitude), 0.4, places=9)
        self.assertLess(found.change, 1e-9)
        self.assertLess(found.residual, 1e-9)

    def test_tells_a_motion_that_is_not_steady(self):
        t = times(20)
        self.assertGreater(response(t, np.exp(0.02 * t) * np.cos(kOmega * t), kOmega).change, 0.1)

    def test_keeps_a_free_oscillation_that_nothing_damps_apart(self):
        t = times(30)
        x = 0.7 * np.cos(kOmega * t) + 0.3 * np.cos(1.9 * t + 1)
        self.assertAlmostEqual(abs(response(t, x, kOmega, damped=False).amplitude), 0.7, delta=0.01)


if __name__ == "__main__":
    unittest.main()
