"""Measures what it costs to solve for added mass: see tools/benchmark --added-mass."""

from __future__ import annotations

import argparse
import csv
import json
import os
import shutil
import sys
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, fields
from pathlib import Path

import numpy as np

from machine import this_machine
from meshes import geodesic_sphere, write_obj
from plimsoll import Plimsoll

kRoot = Path(__file__).resolve().parents[2]
kPublished = kRoot / "tests" / "benchmarks" / "results"
# Edges of the icosahedron are cut into so many parts. From 16 on a mesh has more than 5,000
# triangles, and the program compresses the interactions.
kFrequencies = (4, 5, 7, 10, 14, 16, 22, 32, 45, 64, 100)
kPatience = 60.0  # No plain method is asked for what should take it longer [s].
kRepeats = 3
kLong = 5.0  # What takes longer is run once [s].
kPlain, kDense, kOurs = "constant", "dense", "galerkin"


@dataclass(frozen=True)
class Measurement:
    """`bytes` are those of the largest arrays held at a time, for `dense` of the matrix alone.
    `error`: of the added mass against half of the mesh's displaced mass."""

    method: str
    triangles: int
    unknowns: int
    seconds: float
    bytes: float
    error: float | None = None


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tools/benchmark --added-mass",
        description="Measures time and memory of solving for added mass against the number of "
                    "unknowns (thesis, Fig. 14): spheres of 320 to 200,000 triangles as they are, "
                    "beside the thesis's method (constant on each triangle, dense, LU) on the same "
                    "meshes and a bare dense LU of as many unknowns by LAPACK, both for as long as "
                    "they take less than a minute. Writes added_mass.csv, results.json and "
                    "added_mass.svg and .png. Nothing is judged.")
    parser.add_argument("--program", type=Path, help="the program [PLIMSOLL, or build/plimsoll]",
                        default=Path(os.environ.get("PLIMSOLL", kRoot / "build/plimsoll")))
    parser.add_argument("--out", type=Path, default=kRoot / "out/added_mass",
                        help="folder for the results [out/added_mass]")
    parser.add_argument("--most-triangles", type=int, default=200_000, metavar="N",
                        help="leave out larger meshes [200000]")
    parser.add_argument("--publish", action="store_true",
                        help="also renew chart and table under tests/benchmarks/results")
    return parser.parse_args()


def solved(plimsoll: Plimsoll, mesh: Path, triangles: int, method: str) -> Measurement:
    """By the program, on the mesh's own triangles: the tolerance is met before any is split."""
    body = plimsoll.added_mass(mesh, "--method", method, "--tolerance", "1")
    surge = body["added_mass"][0][0] / body["density"]
    return Measurement(method, triangles, body["unknowns"], body["seconds"], body["bytes"],
                       abs(surge / (0.5 * body["volume"]) - 1))


def eliminated(unknowns: int) -> Measurement:
    """Six right-hand sides through LAPACK's LU of a matrix like the plain method's: dominated by
    its diagonal, full."""
    random = np.random.default_rng(1)
    matrix = random.random((unknowns, unknowns)) / unknowns
    matrix[np.diag_indices(unknowns)] += 1
    right = random.random((unknowns, 6))
    start = time.perf_counter()
    np.linalg.solve(matrix, right)
    return Measurement(kDense, 0, unknowns, time.perf_counter() - start, 8.0 * unknowns**2)


def blas_name() -> str:
    """The library behind NumPy's linear algebra, as its file is named."""
    maps = Path("/proc/self/maps")
    lines = maps.read_text(encoding="utf-8").splitlines() if maps.is_file() else []
    names = {Path(line.split()[-1]).name for line in lines if "blas" in line}
    return ", ".join(sorted(names)) or "BLAS"


def fits(found: list[Measurement], method: str, unknowns: int) -> bool:
    """Whether a method whose time grows with the third power should be done in time."""
    done = [m for m in found if m.method == method]
    return not done or done[-1].seconds * (unknowns / done[-1].unknowns)**3 < kPatience


def measure(plimsoll: Plimsoll, most_triangles: int) -> list[Measurement]:
    found: list[Measurement] = []
    for frequency in kFrequencies:
        triangles = 20 * frequency**2
        if triangles > most_triangles:
            break
        mesh = plimsoll.work / f"sphere_{triangles}.obj"
        write_obj(mesh, geodesic_sphere(frequency))
        methods = {kOurs: lambda: solved(plimsoll, mesh, triangles, kOurs)}
        if fits(found, kPlain, triangles):
            methods[kPlain] = lambda: solved(plimsoll, mesh, triangles, kPlain)
        if fits(found, kDense, triangles):
            methods[kDense] = lambda: eliminated(triangles)
        for run in methods.values():
            found.append(least(run))
            print_line(found[-1])
    return found


def least(run: Callable[[], Measurement]) -> Measurement:
    """Of three runs the shortest, or the first if it takes long."""
    best = run()
    for _ in range(kRepeats - 1):
        if best.seconds < kLong:
            best = min(best, run(), key=lambda m: m.seconds)
    return best


def print_line(m: Measurement) -> None:
    error = "" if m.error is None else f"{m.error:11.1e}"
    print(f"{m.method:10}{m.triangles:9,}{m.unknowns:9,}{m.seconds:11.3f} s"
          f"{m.bytes / 1e6:11.1f} MB{error}", flush=True)


def write_results(out: Path, found: list[Measurement], machine: dict) -> None:
    rows = [asdict(m) for m in found]
    (out / "results.json").write_text(
        json.dumps({"machine": machine, "measurements": rows}, indent=2) + "\n", encoding="utf-8")
    with open(out / "added_mass.csv", "w", newline="", encoding="utf-8") as file:
        lines = csv.DictWriter(file, [field.name for field in fields(Measurement)],
                               lineterminator="\n")
        lines.writeheader()
        lines.writerows(rows)


def main() -> int:
    arguments = parse_arguments()
    program = arguments.program.resolve()
    if not program.is_file():
        print(f"there is no program {program}; tools/benchmark builds it", file=sys.stderr)
        return 2
    from added_mass_chart import draw
    machine = {**this_machine(), "blas": blas_name()}
    work = arguments.out / "work"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    print(f"{machine['cpu']}, {machine['processors']} processors; load average "
          f"{machine['load_average']:.1f} at the start")
    found = measure(Plimsoll(program, kRoot / "scenes", work), arguments.most_triangles)
    write_results(arguments.out, found, machine)
    draw(found, machine, arguments.out)
    if arguments.publish:
        for name in ("added_mass.csv", "added_mass.svg", "added_mass.png"):
            shutil.copy(arguments.out / name, kPublished / name)
    print(f"\nchart: {arguments.out / 'added_mass.png'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
