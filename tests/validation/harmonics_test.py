"""The steady part of a response is found in motions that are made of known parts."""

import importlib.util
import os
import sys
import tempfile
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

    def test_keeps_free_oscillations_that_nothing_damps_apart(self):
        t = times(30)
        x = 0.7 * np.cos(kOmega * t) + 0.3 * np.cos(1.9 * t + 1) + 0.2 * np.cos(0.43 * t)
        found = response(t, x, kOmega)
        # They are found one after the other, each beside what the other still adds.
        self.assertAlmostEqual(abs(found.amplitude), 0.7, delta=2e-3)
        self.assertLess(found.change, 5e-3)

    def test_counts_phases_from_the_crest_at_a_place_that_drifts(self):
        t, k = times(24), 0.3
        place = 2 + 0.15 * t
        x = place + 0.4 * np.sin(kOmega * t - k * place)
        found = response(t, x, kOmega, k * x)
        self.assertAlmostEqual(abs(found.amplitude), 0.4, delta=1e-3)
        self.assertAlmostEqual(np.degrees(np.angle(found.amplitude)), -90, delta=0.3)
        self.assertAlmostEqual(found.drift, 0.15, delta=1e-3)


@unittest.skipUnless(importlib.util.find_spec("yaml"), "needs python3-yaml")
class StillSeaTest(unittest.TestCase):
    def test_has_the_tabulated_wave_numbers(self):
        from still_sea import StillSea
        for period, depth, number in ((10, 20, 0.0518372526), (8, 5, 0.1183910625)):
            wave = StillSea(depth=depth).wave(period, 0, 1)
            self.assertAlmostEqual(wave.number, number, places=9)

    def test_keeps_the_period_at_a_fixed_place_on_a_current(self):
        from still_sea import StillSea
        wave = StillSea(current=(0.4, 0.3, 0)).wave(5, 30, 1, slope=0.05)
        along = 0.4 * np.cos(np.pi / 6) + 0.3 * np.sin(np.pi / 6)
        self.assertAlmostEqual(np.sqrt(9.80665 * wave.number) + wave.number * along, wave.omega)
        self.assertAlmostEqual(wave.amplitude * wave.number, 0.05)
        with self.assertRaisesRegex(RuntimeError, "against the current"):
            StillSea(current=(-4, 0, 0)).wave(5, 0, 1)

    @unittest.skipUnless(os.environ.get("PLIMSOLL"), "PLIMSOLL names no program")
    def test_is_that_of_the_scene_with_its_variables_and_includes(self):
        from still_sea import sea_of
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "sea.yaml").write_text(
                "gravity: 9.7\nwater: {depth: '${2 * half}', current: {depths: [0, 3],"
                " velocities: [[0.4, 0.3, 0], [0, 0, 0]]}}\n")
            scene = Path(folder) / "scene.yaml"
            scene.write_text("plimsoll: 1\nduration: 1\nvariables: {half: 3}\ninclude: sea.yaml\n"
                             "bodies: [{name: a, box: {size: [1, 1, 1]}, density: 500}]\n")
            program = os.environ["PLIMSOLL"]
            sea = sea_of(program, scene, [])
            self.assertEqual((sea.gravity, sea.depth, sea.current), (9.7, 6, (0.4, 0.3, 0)))
            self.assertEqual(sea_of(program, scene, ["variables.half=4"]).depth, 8)
            with self.assertRaisesRegex(RuntimeError, "none.yaml"):
                sea_of(program, Path(folder) / "none.yaml", [])


if __name__ == "__main__":
    unittest.main()
