"""Compares the program with exact answers: see tools/validate."""

from __future__ import annotations

import argparse
import os
import shutil
import sys
import traceback
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from case import Case, Result
from cases import kCases
from plimsoll import Plimsoll
from results import format_number, write_csv

kRoot = Path(__file__).resolve().parents[2]


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tools/validate",
        description="Runs the validation scenes and compares them with exact answers. Writes "
                    "report.html and results.csv. Exit code 1: something is out of tolerance.")
    parser.add_argument("cases", nargs="*", metavar="CASE", help="which cases [all]")
    parser.add_argument("--list", action="store_true", help="list the cases and stop")
    parser.add_argument("--list-tests", action="store_true",
                        help="list the names of the cases that can fail and stop")
    parser.add_argument("--readme", action="store_true",
                        help="rewrite the table in tests/validation/README.md from the last "
                             "results.csv and stop")
    parser.add_argument("--program", type=Path, help="the program [PLIMSOLL, or build/plimsoll]",
                        default=Path(os.environ.get("PLIMSOLL", kRoot / "build/plimsoll")))
    parser.add_argument("--out", type=Path, default=kRoot / "out/validation",
                        help="folder for the results [out/validation]")
    parser.add_argument("--no-report", action="store_true",
                        help="make no report.html, which needs matplotlib")
    parser.add_argument("--jobs", type=int, default=2, help="cases at a time [2]")
    return parser.parse_args()


def chosen_cases(names: list[str]) -> list[Case]:
    known = {case.name: case for case in kCases}
    unknown = [name for name in names if name not in known]
    if unknown:
        sys.exit(f"no such case: {', '.join(unknown)}; tools/validate --list names them all")
    return [known[name] for name in names] if names else list(kCases)


def measured(case: Case, arguments: argparse.Namespace) -> Result | str:
    """The result, or what went wrong."""
    work = arguments.out / "work" / case.name
    shutil.rmtree(work, ignore_errors=True)
    try:
        return case.measure(Plimsoll(arguments.program, kRoot / "scenes", work))
    except Exception:  # A case that breaks is a failure of that case alone.
        return traceback.format_exc()


def measure_all(cases: list[Case], arguments: argparse.Namespace) -> dict[str, Result | str]:
    """Some cases at a time; what measures time goes last and alone."""
    together = [case for case in cases if not case.timed]
    with ThreadPoolExecutor(max(1, arguments.jobs)) as pool:
        results = dict(zip((case.name for case in together),
                           pool.map(lambda case: measured(case, arguments), together)))
    for case in cases:
        if case.timed:
            results[case.name] = measured(case, arguments)
    return {case.name: results[case.name] for case in cases}


def print_result(name: str, result: Result | str) -> None:
    if isinstance(result, str):
        print(f"{name}: BROKEN\n{result}")
        return
    print(f"{name}: {'ok' if result.passed else 'OUT OF TOLERANCE'}")
    for row in result.rows:
        verdict = "    " if row.tolerance is None else "ok  " if row.passed else "FAIL"
        print(f"  {verdict} {row.quantity}: {format_number(row.ours)} "
              f"(reference {format_number(row.reference)}) {row.unit}, error {row.error:.2g}"
              + ("" if row.tolerance is None else f" of {row.tolerance:.2g}"))


def main() -> int:
    arguments = parse_arguments()
    if arguments.list:
        for case in kCases:
            print(f"{case.name:20}{case.title}")
        return 0
    if arguments.list_tests:
        print("\n".join(case.name for case in kCases if not case.timed))
        return 0
    if arguments.readme:
        from accuracy_table import rewrite_accuracy
        rewrite_accuracy(kRoot / "tests" / "validation" / "README.md",
                         arguments.out / "results.csv", kCases)
        return 0
    cases = chosen_cases(arguments.cases)
    arguments.program = arguments.program.resolve()
    if not arguments.program.is_file():
        print(f"there is no program {arguments.program}; tools/validate builds it",
              file=sys.stderr)
        return 2
    results = measure_all(cases, arguments)
    for name, result in results.items():
        print_result(name, result)
    arguments.out.mkdir(parents=True, exist_ok=True)
    write_csv(arguments.out / "results.csv", results)
    if not arguments.no_report:
        from report import write_report
        write_report(arguments.out / "report.html", cases, results)
        print(f"report: {arguments.out / 'report.html'}")
    passed = all(isinstance(r, Result) and r.passed for r in results.values())
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
