"""Measures what a step costs against the number of triangles: see tools/benchmark."""

from __future__ import annotations

import argparse
import csv
import json
import os
import platform
import shutil
import sys
from dataclasses import asdict, dataclass, fields
from pathlib import Path

import numpy as np

from case import Curve, Plot
from cases.cost import hydro_time, kScene, kStates, kStepsTimed, triangle_count
from plimsoll import Plimsoll

kRoot = Path(__file__).resolve().parents[2]
kCounts = (8, 16, 32, 64, 96, 128, 192)  # Slices and stacks of the sphere.


@dataclass(frozen=True)
class Measurement:
    state: str
    threads: int
    triangles: int
    seconds: float  # For the loads of 1 s at 60 Hz.

    @property
    def per_triangle(self) -> float:
        """[ns] a triangle and step."""
        return self.seconds / kStepsTimed / self.triangles * 1e9


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tools/benchmark",
        description="Measures the time that the loads of the water take, against the number of "
                    "triangles (thesis, Fig. 15): 1 s at 60 Hz of a turning sphere, submerged and "
                    "half immersed, all loads but added mass, the least of some runs. Prints a "
                    "table and writes results.json, results.csv, chart.svg and chart.png. Nothing "
                    "is judged; figures of two machines are not comparable.")
    parser.add_argument("--program", type=Path, help="the program [PLIMSOLL, or build/plimsoll]",
                        default=Path(os.environ.get("PLIMSOLL", kRoot / "build/plimsoll")))
    parser.add_argument("--out", type=Path, default=kRoot / "out/benchmark",
                        help="folder for the results [out/benchmark]")
    parser.add_argument("--threads", type=positive, nargs="+", metavar="N",
                        default=sorted({1, processors()}),
                        help="numbers of threads to measure with [1, and all cores]")
    parser.add_argument("--repeats", type=positive, default=3, help="runs of each [3]")
    return parser.parse_args()


def positive(text: str) -> int:
    number = int(text)
    if number < 1:
        raise ValueError
    return number


def processors() -> int:
    """That this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def cpu_name() -> str:
    """As the system names it."""
    path = Path("/proc/cpuinfo")
    lines = path.read_text(encoding="utf-8").splitlines() if path.is_file() else []
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()


def measure(plimsoll: Plimsoll, threads: list[int], repeats: int) -> list[Measurement]:
    return [Measurement(state, number, triangle_count(count),
                        hydro_time(plimsoll, count, height, number, repeats))
            for number in threads for state, height in kStates.items() for count in kCounts]


def print_table(measurements: list[Measurement], machine: dict) -> None:
    print(f"{machine['cpu']}, {machine['processors']} processors, {machine['system']}; "
          f"load average {machine['load_average']:.1f} at the start\n")
    print(f"{'state':15}{'threads':>8}{'triangles':>11}{'1 s at 60 Hz':>16}"
          f"{'a triangle, step':>18}")
    for m in measurements:
        print(f"{m.state:15}{m.threads:8}{m.triangles:11,}{m.seconds * 1e3:13.2f} ms"
              f"{m.per_triangle:15.1f} ns")


def write_results(out: Path, measurements: list[Measurement], machine: dict) -> None:
    rows = [{**asdict(m), "ns_per_triangle_and_step": m.per_triangle} for m in measurements]
    (out / "results.json").write_text(json.dumps(
        {"scene": kScene, "steps": kStepsTimed, "machine": machine, "measurements": rows},
        indent=2) + "\n", encoding="utf-8")
    names = [field.name for field in fields(Measurement)] + ["ns_per_triangle_and_step"]
    with open(out / "results.csv", "w", newline="", encoding="utf-8") as file:
        lines = csv.DictWriter(file, [*names, "cpu"], lineterminator="\n")
        lines.writeheader()
        lines.writerows({**row, "cpu": machine["cpu"]} for row in rows)


def chart(measurements: list[Measurement], machine: dict) -> Plot:
    curves = []
    for threads in dict.fromkeys(m.threads for m in measurements):
        for state, style in zip(kStates, ("o-", "s--")):
            chosen = [m for m in measurements if (m.state, m.threads) == (state, threads)]
            label = f"{state}, {threads} thread{'s' if threads > 1 else ''}"
            curves.append(Curve(label, np.array([m.triangles for m in chosen]),
                                np.array([m.seconds * 1e3 for m in chosen]), style))
    return Plot(f"Loads of 1 s at 60 Hz – {machine['cpu']}", "triangles", "time [ms]", curves,
                log_x=True, log_y=True)


def write_chart(out: Path, plot: Plot) -> None:
    from plots import drawn
    (out / "chart.svg").write_bytes(drawn(plot, "svg"))
    (out / "chart.png").write_bytes(drawn(plot, "png", dpi=200))


def main() -> int:
    arguments = parse_arguments()
    program = arguments.program.resolve()
    if not program.is_file():
        print(f"there is no program {program}; tools/benchmark builds it", file=sys.stderr)
        return 2
    machine = {"cpu": cpu_name(), "processors": processors(),
               "system": f"{platform.system()} {platform.machine()}",
               "load_average": os.getloadavg()[0]}
    arguments.out.mkdir(parents=True, exist_ok=True)
    work = arguments.out / "work"
    shutil.rmtree(work, ignore_errors=True)
    measurements = measure(Plimsoll(program, kRoot / "scenes", work), arguments.threads,
                           arguments.repeats)
    print_table(measurements, machine)
    write_results(arguments.out, measurements, machine)
    write_chart(arguments.out, chart(measurements, machine))
    print(f"\nchart: {arguments.out / 'chart.png'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
