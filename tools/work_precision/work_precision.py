"""Measures run time against error over whole scenes: see tools/benchmark --accuracy."""

from __future__ import annotations

import argparse
import os
import shutil
import sys
import time
from pathlib import Path

kRoot = Path(__file__).resolve().parents[2]
sys.path.append(str(kRoot / "tools" / "validation"))

from experiments import Experiment, kExperiments  # noqa: E402
from machine import this_machine  # noqa: E402  It lies in the folder added above.
from measurement import Laboratory  # noqa: E402
from output import print_table, rewrite_page, write_results  # noqa: E402
from plimsoll import Plimsoll  # noqa: E402
from studies import Finding, Plan, study  # noqa: E402

kFull = Plan(rates=(15, 30, 60, 120, 240, 480, 960, 1920), further=1, further_with_impacts=3,
             tolerances=(1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7), tolerance_rate=15,
             tolerance_rate_with_impacts=60, mesh_rate=120, most_triangles=20480, repeats=9)
kQuick = Plan(rates=(15, 30, 60, 120, 240), further=1, further_with_impacts=2,
              tolerances=(1e-2, 1e-4), tolerance_rate=15, tolerance_rate_with_impacts=60,
              mesh_rate=60, most_triangles=1280, repeats=3)
kPage = kRoot / "tests" / "benchmarks" / "README.md"
kPublished = kPage.parent / "results"
kInterrupted = 130


def parse_arguments() -> argparse.Namespace:
    names = [experiment.name for experiment in kExperiments]
    parser = argparse.ArgumentParser(
        prog="tools/benchmark --accuracy",
        description="Measures run time against error: scenes, steps, meshes and methods of time "
                    "stepping, against exact or converged motions. Prints a table and writes "
                    "results.json, results.csv and the figures work_precision, order and mesh as "
                    "SVG and PNG. One thread, one run at a time. Nothing is judged; times of two "
                    "machines are not comparable, their ratios nearly are.")
    parser.add_argument("--scenes", nargs="+", metavar="NAME", choices=names, default=names,
                        help=f"which of {', '.join(names)} [all]")
    parser.add_argument("--quick", action="store_true",
                        help="fewer steps, meshes and repeats: about a minute")
    parser.add_argument("--program", type=Path, help="the program [PLIMSOLL, or build/plimsoll]",
                        default=Path(os.environ.get("PLIMSOLL", kRoot / "build/plimsoll")))
    parser.add_argument("--out", type=Path, default=kRoot / "out/accuracy",
                        help="folder for the results [out/accuracy]")
    parser.add_argument("--readme", action="store_true",
                        help="also renew the table and figures of tests/benchmarks/README.md")
    arguments = parser.parse_args()
    if arguments.readme and (arguments.quick or set(arguments.scenes) != set(names)):
        parser.error("--readme needs the whole benchmark, without --quick and --scenes")
    return arguments


class Progress:
    """On standard error: a line that is rewritten on a terminal, else one a scene."""

    def __init__(self):
        self._start = time.monotonic()
        self._terminal = sys.stderr.isatty()

    def scene(self, experiment: Experiment) -> None:
        self._say(f"{experiment.title}", "\n")

    def run(self, words: str) -> None:
        if self._terminal:
            self._say(words, "\r")

    def _say(self, words: str, end: str) -> None:
        seconds = time.monotonic() - self._start
        clear = "\033[K" if self._terminal else ""
        print(f"{clear}{seconds:6.0f} s  {words}", end=end, file=sys.stderr, flush=True)


def measure(arguments: argparse.Namespace, machine: dict, findings: list[Finding]) -> None:
    """Adds to the findings and writes them after every scene."""
    progress = Progress()
    plan = kQuick if arguments.quick else kFull
    plimsoll = Plimsoll(arguments.program, kRoot / "scenes", arguments.out / "work")
    laboratory = Laboratory(plimsoll, plan.repeats, progress.run)
    for experiment in kExperiments:
        if experiment.name not in arguments.scenes:
            continue
        progress.scene(experiment)
        findings.append(Finding(experiment))
        study(laboratory, experiment, plan, findings[-1])
        write_results(arguments.out, findings, machine)


def present(arguments: argparse.Namespace, machine: dict, findings: list[Finding]) -> None:
    from charts import draw_all
    write_results(arguments.out, findings, machine)
    figures = draw_all(findings, arguments.out)
    print_table(findings)
    print("figures: " + ", ".join(str(figure) for figure in figures))


def publish(arguments: argparse.Namespace, findings: list[Finding]) -> None:
    """Renews the table and figures of tests/benchmarks/README.md."""
    kPublished.mkdir(parents=True, exist_ok=True)
    for name in ("work_precision.svg", "order.svg", "mesh.svg"):
        shutil.copy(arguments.out / name, kPublished / name)
    shutil.copy(arguments.out / "results.csv", kPublished / "work_precision.csv")
    rewrite_page(kPage, findings)


def main() -> int:
    arguments = parse_arguments()
    arguments.program = arguments.program.resolve()
    if not arguments.program.is_file():
        print(f"there is no program {arguments.program}; tools/benchmark builds it",
              file=sys.stderr)
        return 2
    machine = this_machine()
    shutil.rmtree(arguments.out / "work", ignore_errors=True)
    (arguments.out / "work").mkdir(parents=True)
    findings: list[Finding] = []
    try:
        measure(arguments, machine, findings)
    except KeyboardInterrupt:
        print("\ninterrupted; what was measured is kept", file=sys.stderr)
        present(arguments, machine, [finding for finding in findings if finding.rows])
        return kInterrupted
    present(arguments, machine, findings)
    if arguments.readme:
        publish(arguments, findings)
    return 0


if __name__ == "__main__":
    sys.exit(main())
