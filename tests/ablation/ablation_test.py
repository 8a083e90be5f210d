"""Tests of tools/ablate:  ablation_test.py ENGINE_PROGRAM ABLATED_PROGRAM

The two print the states of the same bodies; the second has its constants from the environment."""

import os
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "tools" / "ablation"))

import ablate  # noqa: E402
import constants  # noqa: E402
from laboratory import SceneResult  # noqa: E402


def states(program, **values):
    environment = {**os.environ, **{constants.kPrefix + name: v for name, v in values.items()}}
    return subprocess.run([program], env=environment, capture_output=True, check=True).stdout


class Ablation(unittest.TestCase):
    plain, ablated = None, None

    def test_an_engine_without_variables_moves_by_the_same_bytes(self):
        self.assertEqual(states(self.plain), states(self.ablated))

    def test_a_variable_changes_a_constant(self):
        self.assertNotEqual(states(self.plain), states(self.ablated, kContactDepth="0.01"))
        self.assertEqual(states(self.plain), states(self.plain, kContactDepth="0.01"))

    def test_a_value_that_is_no_number_is_refused(self):
        with self.assertRaises(subprocess.CalledProcessError):
            states(self.ablated, kFriction="rough")

    def test_every_mechanism_names_constants_of_the_engine(self):
        self.assertGreater(len(ablate.read_mechanisms()), 10)

    def test_every_scene_is_there(self):
        for scene in ablate.read_scenes():
            self.assertTrue((ablate.kRoot / "scenes" / f"{scene}.yaml").is_file(), scene)

    def test_only_what_changes_is_in_the_table(self):
        results = {"a": {"unchanged": SceneResult(1e-3, True), "off": SceneResult(1e-3, True)},
                   "b": {"unchanged": SceneResult(1e-3, True), "off": SceneResult(3e-3, False)},
                   "c": {"unchanged": SceneResult(1e-3, True), "off": SceneResult(1.001e-3, False)},
                   "d": {"unchanged": SceneResult(1e-3, True), "off": SceneResult(None, False, stopped=True)}}
        self.assertEqual(ablate.scene_words(results, "off"),
                         "d stops, b 3 ×, 1 by less than 1% or 1e-07 m")


if __name__ == "__main__":
    Ablation.ablated, Ablation.plain = sys.argv.pop(), sys.argv.pop()
    unittest.main()
