"""The table of accuracy in tests/validation/README.md, between its two marks."""

from __future__ import annotations

import csv
import sys
from pathlib import Path

from case import Case
from marked import rewrite_marked, table_lines
from results import format_number


def rewrite_accuracy(page: Path, results: Path, cases: list[Case]) -> None:
    for path in (page, results):
        if not path.is_file():
            hint = "" if path == page else "; run tools/validate first"
            sys.exit(f"{path} is missing{hint}")
    rewrite_marked(page, "accuracy", _table(results, cases))


def _table(results: Path, cases: list[Case]) -> list[str]:
    """One row per headline quantity of a case."""
    titles = {case.name: case.title for case in cases}
    with open(results, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file)
                if row["headline"] == "yes" and row["case"] in titles]
    missing = [name for name, case in zip(titles, cases)
               if not case.timed and name not in {row["case"] for row in rows}]
    if missing:
        sys.exit(f"{results} lacks {', '.join(missing)}; run tools/validate without names first")
    header = ("case", "quantity", "kind", "reference", "ours", "error", "tolerance")
    return table_lines(header, [_words(row, titles) for row in rows], words=3)


def _words(row: dict[str, str], titles: dict[str, str]) -> tuple[str, ...]:
    if not row["ours"]:
        sys.exit(f"{row['case']} could not be measured; the table stays as it is")
    unit = "" if row["unit"] == "–" else f" {row['unit']}"
    tolerance = f"{float(row['tolerance']):.2g}" if row["tolerance"] else ""
    return (titles[row["case"]], row["quantity"], row["kind"],
            f"{format_number(float(row['reference']))}{unit}",
            f"{format_number(float(row['ours']))}{unit}", f"{float(row['error']):.1e}", tolerance)
