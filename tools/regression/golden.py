"""Golden trajectories of the scenes: see tools/golden.

tests/golden/SCENE/ holds
  trajectory.csv   of scenes/SCENE.yaml, at some forty times, with ten digits
  tolerances.yaml  what a later run may differ by (plimsoll compare), with the reason
  origin.json      the version and the command that made it, and the interval of its rows
"""

import argparse
import csv
import json
import os
from pathlib import Path
import shutil
import subprocess
import sys
import tempfile

ROOT = Path(__file__).resolve().parents[2]
GOLDEN = ROOT / "tests" / "golden"
SCENES = ROOT / "scenes"
ROWS = 40
DIGITS = 10
DIFFERENT = 1  # Exit code of plimsoll compare.


class GoldenError(Exception):
    """Something that the user can mend."""


def known(golden):
    return sorted(file.parent.name for file in golden.glob("*/origin.json"))


def interval_for(program, scene):
    """A round time near duration / ROWS [s], which a whole number of steps makes up."""
    with tempfile.TemporaryDirectory() as out:
        run(program, scene, out, None)
        summary = json.loads((Path(out) / "summary.json").read_text())
    step = summary["simulated_seconds"] / summary["steps"]
    return round(max(1, round(summary["steps"] / ROWS)) * step, 9)


def arguments(scene, every):
    log = [] if every is None else ["--set", f"log.every={every}"]
    return ["run", f"scenes/{scene}.yaml", "--no-render", *log]


def run(program, scene, out, every):
    """Runs a scene with the log's interval [s]. @return the folder of the run."""
    command = [program, *arguments(scene, every), "--quiet", "--out", out]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    if done.returncode != 0:
        raise GoldenError(f"{scene}: exit code {done.returncode}\n{done.stderr}")
    return Path(out)


def compare(program, golden, new):
    """@return what plimsoll compare says, and whether they are the same."""
    done = subprocess.run([program, "compare", golden, new], capture_output=True, text=True)
    if done.returncode not in (0, DIFFERENT):
        raise GoldenError(done.stderr)
    return done.stdout, done.returncode == 0


def write_rounded(source, target):
    """Copies a trajectory with DIGITS digits."""
    with open(source, newline="") as old, open(target, "w", newline="") as new:
        rows = csv.reader(old)
        table = csv.writer(new, lineterminator="\n")
        table.writerow(next(rows))
        for row in rows:
            table.writerow([f"{float(row[0]):.12g}", row[1],
                            *(f"{float(number):.{DIGITS}g}" for number in row[2:])])


def unsolved(out):
    """@return the bodies of a run whose constraints missed their tolerance in some substep."""
    bodies = json.loads((out / "summary.json").read_text())["bodies"]
    return [name for name, body in bodies.items() if body["motion"]["unconverged_substeps"]]


def check(program, golden, keep):
    """@return true if a new run is the golden one within tolerance and has solved its constraints."""
    scene = golden.name
    origin = json.loads((golden / "origin.json").read_text())
    with tempfile.TemporaryDirectory() as folder:
        out = run(program, scene, keep / scene if keep else folder, origin["every"])
        said, same = compare(program, golden, out / "trajectory.csv")
        missed = unsolved(out)
    if missed:
        print(f"{scene}: constraints were not solved in all substeps of {', '.join(missed)}")
        return False
    if not same:
        print(f"{scene} is no longer what {origin['version']} made by\n  {origin['command']}\n{said}")
        print(f"If that is meant: tools/golden renew {scene}")
    else:
        print(f"{scene}: the same within tolerance")
    return same


def renew(program, golden):
    """Replaces the golden trajectory, and prints what changes."""
    scene = golden.name
    golden.mkdir(parents=True, exist_ok=True)
    if not (golden / "tolerances.yaml").exists():
        shutil.copy(Path(__file__).parent / "tolerances.yaml", golden)
    every = interval_for(program, scene)
    version = subprocess.run([program, "--version"], capture_output=True, text=True).stdout.strip()
    with tempfile.TemporaryDirectory() as folder:
        out = run(program, scene, folder, every)
        if (golden / "trajectory.csv").exists():
            said, same = compare(program, golden, out / "trajectory.csv")
            print(f"{scene}: {'within tolerance of' if same else 'NOT'} what it was\n{said}")
        else:
            print(f"{scene}: new")
        write_rounded(out / "trajectory.csv", golden / "trajectory.csv")
    origin = {"version": version, "command": " ".join(["plimsoll", *arguments(scene, every)]),
              "every": every}
    (golden / "origin.json").write_text(json.dumps(origin, indent=2) + "\n")
    if (golden / "picture.png").exists():
        print(f"Its picture is drawn from this motion: tools/golden_pictures renew {scene}")


def main():
    parser = argparse.ArgumentParser(
        prog="tools/golden", description="Golden trajectories of the scenes: compares new runs "
        "with them, or replaces them and prints what changes.")
    parser.add_argument("action", nargs="?", choices=("check", "renew", "list"), default="check")
    parser.add_argument("scenes", nargs="*", metavar="SCENE",
                        help="name of a file in scenes/, without .yaml [all that are kept]")
    parser.add_argument("--program", default=os.environ.get("PLIMSOLL", str(ROOT / "build/plimsoll")))
    parser.add_argument("--golden", type=Path, default=GOLDEN, metavar="DIR",
                        help="folder of the golden runs [tests/golden]")
    parser.add_argument("--keep", type=Path, metavar="DIR",
                        help="check: keep the new run in DIR/SCENE")
    options = parser.parse_args()
    program = str(Path(options.program).resolve())
    keep = options.keep and options.keep.resolve()
    scenes = [Path(scene).stem for scene in options.scenes] or known(options.golden)
    if options.action == "list":
        print("\n".join(known(options.golden)))
        return 0
    same = True
    for scene in scenes:
        if not (SCENES / f"{scene}.yaml").exists():
            raise GoldenError(f"there is no scene scenes/{scene}.yaml")
        if options.action == "renew":
            renew(program, options.golden / scene)
        elif scene not in known(options.golden):
            raise GoldenError(f"no golden run of {scene} is kept; kept are "
                              f"{', '.join(known(options.golden))}. "
                              f"To make it: tools/golden renew {scene}")
        else:
            same = check(program, options.golden / scene, keep) and same
    return 0 if same else DIFFERENT


if __name__ == "__main__":
    try:
        sys.exit(main())
    except GoldenError as error:
        print(f"tools/golden: {error}", file=sys.stderr)
        sys.exit(2)
