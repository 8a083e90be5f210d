"""Measures what a step costs: see tools/benchmark."""

from __future__ import annotations

import argparse
import csv
import json
import os
import shutil
import subprocess
import sys
from dataclasses import astuple, dataclass, fields
from pathlib import Path

from machine import this_machine
from marked import rewrite_marked, table_lines

kRoot = Path(__file__).resolve().parents[2]
kPage = kRoot / "tests" / "benchmarks" / "README.md"
kPublished = kPage.parent / "results"
kLeastTime = 0.05  # Of one repetition, of what takes less than that [s].
kUnits = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
kFewest, kMost = 1280, 81920  # Triangles between which the page gives the growth.

# Loads in the table and the figure of the page: state and what of BM_Hydro.
kShown = {("submerged", ""): "submerged", ("half", ""): "half immersed",
          ("waves", ""): "half immersed, in a wave",
          ("jonswap", ""): "half immersed, in a sea of 64 waves",
          ("jonswap256", ""): "half immersed, in a sea of 256 waves",
          ("half", "viscous"): "half immersed, with viscous drag",
          ("waves", "viscous"): "half immersed, in a wave, with viscous drag",
          ("jonswap", "viscous"): "half immersed, in a sea of 64 waves, with viscous drag",
          ("half", "no_tree"): "half immersed, without the tree",
          ("half", "plain"): "half immersed, plain sum, not vectorised",
          ("half", "wind"): "half immersed, the wind alone"}
kBare = ("", "bare")
# Arrangements of BM_Step, by the end of its name.
kArrangements = {"": "apart", "crates": "in heaps of ten", "heap": "in one heap",
                 "boxes": "plain boxes apart", "boxes_heap": "plain boxes in one heap"}
kFixed = ("real_time", "iterations:")  # What Google Benchmark adds to names.


@dataclass(frozen=True)
class Load:
    """One evaluation of the loads on a sphere."""

    state: str
    what: str
    threads: int
    triangles: int
    seconds: float


@dataclass(frozen=True)
class Step:
    """One step of a world."""

    arrangement: str
    bodies: int
    seconds: float
    held: float  # Share of the bodies' steps that contacts had a part in.

    @property
    def per_body(self) -> float:
        """[µs]"""
        return self.seconds / self.bodies * 1e6


@dataclass(frozen=True)
class Findings:
    machine: dict
    repeats: int
    loads: list[Load]
    steps: list[Step]
    others: dict[str, float | str]  # Seconds by name, or why there are none.

    def curve(self, state: str, what: str) -> dict[int, float]:
        """Seconds by number of triangles, on one thread."""
        return {load.triangles: load.seconds for load in self.loads
                if (load.state, load.what, load.threads) == (state, what, 1)}


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tools/benchmark",
        description="Runs tests/benchmarks: the loads of the water against the number of triangles "
                    "(thesis, Fig. 15) beside a bare vectorised loop, a step against the number of "
                    "bodies, solving for added mass, reading a mesh, a picture. Prints tables and "
                    "writes benchmarks.json, hydro_cost.csv, bodies.csv and the figures hydro_cost "
                    "and bodies as SVG and PNG. Takes some minutes. Nothing is judged; times of "
                    "two machines are not comparable, their ratios nearly are.")
    parser.add_argument("--program", type=Path,
                        help="the benchmarks [PLIMSOLL_BENCH, or build/plimsoll_bench]",
                        default=Path(os.environ.get("PLIMSOLL_BENCH",
                                                    kRoot / "build/plimsoll_bench")))
    parser.add_argument("--out", type=Path, default=kRoot / "out/benchmark",
                        help="folder for the results [out/benchmark]")
    parser.add_argument("--repeats", type=positive, default=5,
                        help="runs of each, in random order, of which the least counts [5]")
    parser.add_argument("--readme", action="store_true",
                        help="also renew the tables and figures of tests/benchmarks/README.md")
    return parser.parse_args()


def positive(text: str) -> int:
    number = int(text)
    if number < 1:
        raise ValueError
    return number


def run(program: Path, out: Path, repeats: int, machine: dict) -> list[dict]:
    """What the program writes to benchmarks.json, with the machine added to its head."""
    path = out / "benchmarks.json"
    # Interleaved, so that what else the machine does in the meantime meets all of them.
    subprocess.run([program, f"--benchmark_out={path}", "--benchmark_out_format=json",
                    f"--benchmark_repetitions={repeats}", f"--benchmark_min_time={kLeastTime}",
                    "--benchmark_enable_random_interleaving=true"],
                   stdout=subprocess.DEVNULL, check=True)
    content = json.loads(path.read_text(encoding="utf-8"))
    content["context"] |= machine
    path.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
    return content["benchmarks"]


def gathered(rows: list[dict], machine: dict, repeats: int) -> Findings:
    """Of each benchmark the shortest run."""
    found = Findings(machine, repeats, [], [], {})
    runs: dict[str, list[dict]] = {}
    for row in sorted(rows, key=lambda row: row["family_index"]):  # As they are registered.
        if row["run_type"] == "iteration":
            runs.setdefault(row["run_name"], []).append(row)
    for name, members in runs.items():
        parts = [part for part in name.split("/") if not part.startswith(kFixed)]
        if members[0].get("error_occurred"):
            found.others["/".join(parts)] = members[0]["error_message"]
            continue
        best = min(members, key=lambda row: seconds_of(name, row))
        add(found, parts, seconds_of(name, best), best)
    return found


def add(found: Findings, parts: list[str], seconds: float, row: dict) -> None:
    match parts:
        case ["BM_Hydro", "icosphere", triangles, state, threads, *what]:
            found.loads.append(Load(state, "/".join(what), int(threads), int(triangles), seconds))
        case ["BM_BareLoop", _, triangles]:
            found.loads.append(Load(*kBare, 1, int(triangles), seconds))
        case ["BM_Step", bodies, *heap]:
            found.steps.append(Step(kArrangements["".join(heap)], int(bodies), seconds,
                                    row["held"]))
        case _:
            found.others["/".join(parts)] = seconds


def seconds_of(name: str, row: dict) -> float:
    """The processor's time, or the clock's where there are several threads."""
    several = name.endswith("/real_time") or (
        name.startswith("BM_Hydro/") and name.split("/")[4] != "1")
    return row["real_time" if several else "cpu_time"] * kUnits[row["time_unit"]]


def time_words(seconds: float | str) -> str:
    """Three digits and a unit; words as they are."""
    if isinstance(seconds, str):
        return seconds
    unit, factor = next((pair for pair in (("s", 1), ("ms", 1e-3)) if seconds >= pair[1]),
                        ("µs", 1e-6))
    value = seconds / factor
    return f"{value:.{0 if value >= 100 else 1 if value >= 10 else 2}f} {unit}"


def print_tables(found: Findings) -> None:
    machine = found.machine
    print(f"{machine['cpu']}, {machine['processors']} processors, {machine['system']}; "
          f"load average {machine['load_average']:.1f} at the start\n")
    kinds = dict.fromkeys((load.state, load.what) for load in found.loads if load.threads == 1)
    counts = sorted(found.curve(*kBare))
    print(f"{'loads of a sphere, triangles:':32}" + "".join(f"{count:>12,}" for count in counts))
    for state, what in kinds:
        curve = found.curve(state, what)
        print(f"{' '.join((state, what)).strip():32}" + "".join(
            f"{time_words(curve[count]) if count in curve else '':>12}" for count in counts))
    for load in found.loads:
        if load.threads > 1:
            words = f"{load.state} {load.what}, {load.threads} threads"
            print(f"{words}, {load.triangles:,} triangles: {time_words(load.seconds)}")
    print(f"\n{'step of 1/60 s':16}{'bodies':>8}{'step':>12}{'a body':>12}")
    for step in found.steps:
        print(f"{step.arrangement:16}{step.bodies:8,}{time_words(step.seconds):>12}"
              f"{time_words(step.per_body * 1e-6):>12}")
    print()
    for name, seconds in found.others.items():
        print(f"{name:28}{time_words(seconds):>12}")


def write_csv(path: Path, rows: list) -> None:
    """Of dataclasses of one kind."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow(field.name for field in fields(rows[0]))
        lines.writerows(astuple(row) for row in rows)


def page_lines(found: Findings) -> list[str]:
    machine = found.machine
    return [f"Measured on one thread ({machine['cpu']}), the least of {found.repeats} runs.", "",
            *load_table(found), "", *step_table(found), "", *other_table(found)]


def load_table(found: Findings) -> list[str]:
    bare = found.curve(*kBare)
    rows = []
    for kind, title in {**kShown, kBare: "bare vectorised loop"}.items():
        curve = found.curve(*kind)
        rows.append((title, time_words(curve[kFewest]), time_words(curve[kMost]),
                     f"{curve[kMost] / curve[kFewest]:.3g} ×",
                     f"{curve[kMost] / bare[kMost]:.3g} ×"))
    return table_lines(("loads on a sphere", f"{kFewest:,} triangles", f"{kMost:,} triangles",
                        f"growth, {kMost // kFewest} × the triangles",
                        "the latter over the bare loop"), rows, words=1)


def step_table(found: Findings) -> list[str]:
    counts = sorted({step.bodies for step in found.steps})
    cells = {(step.arrangement, step.bodies): time_words(step.per_body * 1e-6)
             for step in found.steps}
    rows = [(name, *(cells.get((name, count), "–") for count in counts))
            for name in kArrangements.values()]
    return table_lines(("step of 1/60 s, a body, crates afloat",
                        *(f"{n:,} {'body' if n == 1 else 'bodies'}" for n in counts)), rows,
                       words=1)


kOthers = {"BM_AddedMass": "added mass of a sphere of {} triangles, solved once",
           "BM_WettedAddedMass": "added mass of the wetted part of a sphere of {} triangles, half "
                                 "immersed, in a wave",
           "BM_WaveLoad": "load of the wave on that added mass, with the added mass",
           "BM_LoadsBeside": "all loads on that sphere in the same state",
           "BM_HollowHull": "step of an open hull of {} triangles that rolls in still water, dry inside",
           "BM_LiddedHull": "the same under a lid",
           "BM_HollowHullInWave": "step of the open hull in a wave",
           "BM_LiddedHullInWave": "the same under a lid, in a wave",
           "BM_MeshLoad": "mesh file of {} triangles, read, welded and checked",
           "BM_Frame": "picture of a teapot of {} triangles half in water, software rasteriser, "
                       "all processors",
           "BM_Run": "teapot drop of {} triangles, 3.6 s in steps of 10 ms: read, run and logged",
           "BM_CratesInContact": "{} crates of 12 triangles with added mass fall into the water, in "
                                 "contact, 2 s on one thread: read, run and logged",
           "BM_Raft": "{} such crates side by side, 4 s on two threads: read, run and logged",
           "BM_Storm": "{} crates, barrels, buoys, planks and a launch in 64 waves of H_s 3.5 m, "
                       "5 s on two threads: read, run and logged"}


def other_table(found: Findings) -> list[str]:
    """Of each kind the largest."""
    largest = {}
    for name, seconds in found.others.items():
        kind, _, count = name.partition("/")
        if kind not in kOthers or isinstance(seconds, str):
            continue
        if int(count) > largest.get(kind, (0, 0))[0]:
            largest[kind] = int(count), seconds
    rows = [(title.format(f"{largest[kind][0]:,}"), time_words(largest[kind][1]))
            for kind, title in kOthers.items() if kind in largest]
    return table_lines(("besides", "time"), rows, words=1)


def publish(found: Findings, out: Path) -> None:
    for name in ("hydro_cost.csv", "hydro_cost.svg", "bodies.csv", "bodies.svg"):
        shutil.copy(out / name, kPublished / name)
    rewrite_marked(kPage, "cost", page_lines(found))


def main() -> int:
    arguments = parse_arguments()
    program = arguments.program.resolve()
    if not program.is_file():
        print(f"there is no program {program}; tools/benchmark builds it", file=sys.stderr)
        return 2
    from benchmark_charts import draw
    machine = this_machine()
    arguments.out.mkdir(parents=True, exist_ok=True)
    print(f"running the benchmarks, {arguments.repeats} times each", file=sys.stderr)
    rows = run(program, arguments.out, arguments.repeats, machine)
    found = gathered(rows, machine, arguments.repeats)
    print_tables(found)
    write_csv(arguments.out / "hydro_cost.csv", found.loads)
    write_csv(arguments.out / "bodies.csv", found.steps)
    figures = draw(found, arguments.out)
    if arguments.readme:
        publish(found, arguments.out)
    print("\nfigures: " + ", ".join(str(figure) for figure in figures))
    return 0


if __name__ == "__main__":
    sys.exit(main())
