"""That tools/golden tells a motion that has changed, and renews it."""

import json
from pathlib import Path
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = Path(__file__).resolve().parents[2]
SCENE = "thesis_cube_768"
OTHER = "thesis_sphere_480"
PROGRAM = sys.argv.pop()


def golden(*arguments):
    return subprocess.run(
        [sys.executable, "-B", ROOT / "tools/regression/golden.py", *arguments, "--program", PROGRAM],
        capture_output=True, text=True)


class Golden(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.kept = Path(folder.name)
        shutil.copytree(ROOT / "tests/golden" / SCENE, self.kept / SCENE)

    def move(self, shift):
        """Moves the last row of what is kept along x [m]."""
        file = self.kept / SCENE / "trajectory.csv"
        lines = file.read_text().splitlines()
        row = lines[-1].split(",")
        row[2] = str(float(row[2]) + shift)
        file.write_text("\n".join([*lines[:-1], ",".join(row)]) + "\n")

    def test_a_motion_that_has_not_changed_passes(self):
        self.move(1e-8)
        done = golden("check", SCENE, "--golden", self.kept)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_one_that_has_is_told_with_its_origin(self):
        self.move(1e-3)
        done = golden("check", "--golden", self.kept)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("plimsoll run scenes/thesis_cube_768.yaml --no-render", done.stdout)
        self.assertRegex(done.stdout, r"position +0\.001 +[\d.e-]+ m .* exceeds it from")

    def test_renewing_prints_what_changed_and_then_it_passes(self):
        self.move(1e-3)
        done = golden("renew", SCENE, "--golden", self.kept)
        self.assertIn("NOT what it was", done.stdout)
        self.assertRegex(done.stdout, r"position +0\.001 +[\d.e-]+ m ")
        self.assertEqual(golden("check", "--golden", self.kept).returncode, 0)

    def test_renewing_names_the_command_for_a_picture_if_one_is_kept(self):
        self.assertNotIn("golden_pictures", golden("renew", SCENE, "--golden", self.kept).stdout)
        (self.kept / SCENE / "picture.png").touch()
        done = golden("renew", SCENE, "--golden", self.kept)
        self.assertIn(f"tools/golden_pictures renew {SCENE}", done.stdout)

    def test_new_runs_are_kept_each_in_a_folder_of_its_own(self):
        shutil.copytree(ROOT / "tests/golden" / OTHER, self.kept / OTHER)
        runs = self.kept / "runs"
        done = golden("check", SCENE, OTHER, "--golden", self.kept, "--keep", runs)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for scene in SCENE, OTHER:
            summary = json.loads((runs / scene / "summary.json").read_text())
            self.assertIn(scene, summary["scene"])

    def test_a_scene_that_is_not_kept_is_code_two(self):
        done = golden("check", "teapot_drop", "--golden", self.kept)
        self.assertEqual(done.returncode, 2)
        self.assertIn("kept are thesis_cube_768", done.stderr)


if __name__ == "__main__":
    unittest.main()
