"""Exports a scene as a unit and has FMPy, an importer of others, check and run it.

fmpy_test.py PROGRAM; the exit code is 77 where FMPy is missing.
"""

import csv
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import fmpy
    import fmpy.validation
except ImportError:
    print("skipped: no FMPy")
    sys.exit(77)

SCENE = Path(__file__).resolve().parent / "rigged_boxes.yaml"
COLUMNS = ("x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz")


def last_rows(folder):
    """The last row of each body of a run, and its time."""
    with open(folder / "trajectory.csv", newline="") as file:
        rows = {row["body"]: row for row in csv.DictReader(file)}
    return rows, float(next(iter(rows.values()))["time"])


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        unit = str(folder / "unit.fmu")
        subprocess.run([program, "export", SCENE, unit, "--quiet"], check=True)
        subprocess.run([program, "run", SCENE, "--out", folder / "run", "--no-render", "--quiet"], check=True)
        problems = fmpy.validation.validate_fmu(unit)
        assert not problems, problems
        step = float(fmpy.read_model_description(unit).coSimulation.fixedInternalStepSize)
        rows, end = last_rows(folder / "run")
        seen = fmpy.simulate_fmu(unit, stop_time=end, output_interval=2 * step)
        assert abs(seen["time"][-1] - end) < step / 100, seen["time"][-1]
        for body, row in rows.items():
            for column in COLUMNS:
                assert seen[f"{body}.{column}"][-1] == float(row[column]), (body, column)
    print(f"{len(rows)} bodies have the states of the run after {end:g} s")


main()
