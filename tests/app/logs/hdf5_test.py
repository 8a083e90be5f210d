"""hdf5_test.py PROGRAM: run.h5, read by h5py, has the numbers of the CSV files bit by bit.

Ends with 77, skipped, where there is no h5py or the program was built without HDF5.
"""

import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import h5py
    import numpy as np
except ImportError:
    print("skipped: there is no h5py")
    sys.exit(77)

SCENE = """
plimsoll: 1
title: "A raft's ü"
duration: 3
step: 0.01
water: {}
hydro: {added_mass: none}
log:
  forces: true
  probes: [{name: g é, wave: [1, 2]}, {name: d, wave: [1, 2], depth: 1}, {name: p, body: ., at: [0, 0, 1]}]
bodies:
  - {name: a/b %é, box: {size: [1, 1, 1]}, density: 500, position: [0, 0, 1],
     angular_velocity: [1, 2, 3]}
  - {name: ., sphere: {radius: 0.5}, density: 700, position: [4, 0, 1]}
joints:
  - {name: k é, type: hinge, bodies: [., world], anchor: [4, 0, 2], axis: [0, 1, 0]}
  - {name: b, type: ball, bodies: [a/b %é, world], anchor: [0, 0, 2]}
"""


def table(file, kind="body"):
    """The columns of a CSV file, each T x N, by their names; the times, and the bodies or probes."""
    with open(file, encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    names = list(dict.fromkeys(row[kind] for row in rows))
    columns = {name: np.array([float(row[name] or "nan") for row in rows]).reshape(-1, len(names))
               for name in rows[0] if name != kind}
    return columns, names


class Hdf5(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.kept.name)
        (cls.folder / "raft.yaml").write_text(SCENE, encoding="utf-8")
        for form in "csv", "hdf5":
            done = subprocess.run(
                [program, "run", "raft.yaml", "--out", form, "--format", form, "--quiet"],
                cwd=cls.folder, capture_output=True, text=True)
            if "built without HDF5" in done.stderr:
                print("skipped: the program was built without HDF5")
                sys.exit(77)
            assert done.returncode == 0, done.stderr
        cls.run_file = h5py.File(cls.folder / "hdf5" / "run.h5", "r")

    @classmethod
    def tearDownClass(cls):
        cls.run_file.close()
        cls.kept.cleanup()

    def test_numbers_are_those_of_the_csv_files_bit_by_bit(self):
        expected, bodies = table(self.folder / "csv" / "trajectory.csv")
        expected.update(table(self.folder / "csv" / "forces.csv")[0])
        self.assertEqual(list(self.run_file["body"].asstr()), bodies)
        times = expected.pop("time")
        self.assertEqual(len(times), 301)  # more than two chunks
        self.assertEqual(self.run_file["time"][:].tobytes(), times[:, 0].tobytes())
        for name, dataset in self.run_file.items():
            if name in ("time", "body") or name.startswith(("probe", "joint")):
                continue
            for i, column in enumerate(dataset.attrs.get("columns", [name])):
                numbers = dataset[:, :, i] if dataset.ndim == 3 else dataset[:]
                self.assertEqual(numbers.tobytes(), expected.pop(column).tobytes(), column)
        self.assertEqual(expected, {})

    def test_other_tables_are_those_of_the_csv_files(self):
        for kind in "probe", "joint":
            expected, names = table(self.folder / "csv" / f"{kind}s.csv", kind)
            self.assertEqual(list(self.run_file[kind].asstr()), names)
            expected.pop("time")
            for name, dataset in self.run_file.items():
                if not name.startswith(kind + "_"):
                    continue
                for i, column in enumerate(dataset.attrs.get("columns", [name[len(kind) + 1:]])):
                    numbers = dataset[:, :, i] if dataset.ndim == 3 else dataset[:]
                    np.testing.assert_array_equal(numbers, expected.pop(column), column)
            self.assertEqual(expected, {})

    def test_says_what_it_is_of(self):
        self.assertEqual(self.run_file.attrs["title"], "A raft's ü")
        self.assertEqual(self.run_file.attrs["scene"], "raft.yaml")
        self.assertEqual(self.run_file.attrs["format"], "1")
        self.assertEqual(self.run_file["position"].attrs["units"], "m")
        self.assertEqual(list(self.run_file["orientation"].attrs["columns"]),
                         ["qw", "qx", "qy", "qz"])
        for dataset in self.run_file.values():
            self.assertTrue(dataset.name in ("/body", "/probe", "/joint") or "units" in dataset.attrs)


if __name__ == "__main__":
    program = str(pathlib.Path(sys.argv.pop()).resolve())
    unittest.main()
