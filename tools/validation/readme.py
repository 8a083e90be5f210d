"""The table of accuracy in README.md, between its two marks."""

from __future__ import annotations

import csv
import sys
from pathlib import Path

from case import Case
from results import format_number

kBegin = "<!-- accuracy:begin -->"
kEnd = "<!-- accuracy:end -->"


def rewrite_readme(readme: Path, results: Path, cases: list[Case]) -> None:
    for path in (readme, results):
        if not path.is_file():
            hint = "" if path == readme else "; run tools/validate first"
            sys.exit(f"{path} is missing{hint}")
    text = readme.read_text(encoding="utf-8")
    if text.count(kBegin) != 1 or text.count(kEnd) != 1 or text.index(kBegin) > text.index(kEnd):
        sys.exit(f"{readme} lacks the marks {kBegin} and {kEnd}, once each and in this order")
    before, rest = text.split(kBegin)
    after = rest.split(kEnd)[1]
    readme.write_text(f"{before}{kBegin}\n{_table(results, cases)}\n{kEnd}{after}",
                      encoding="utf-8")


def _table(results: Path, cases: list[Case]) -> str:
    """The quantities that stand for their cases."""
    titles = {case.name: case.title for case in cases}
    with open(results, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file)
                if row["headline"] == "yes" and row["case"] in titles]
    missing = [name for name, case in zip(titles, cases)
               if not case.timed and name not in {row["case"] for row in rows}]
    if missing:
        sys.exit(f"{results} lacks {', '.join(missing)}; run tools/validate without names first")
    lines = ["| case | quantity | kind | reference | ours | error | tolerance |",
             "| --- | --- | --- | ---: | ---: | ---: | ---: |"]
    lines += [_line(row, titles) for row in rows]
    return "\n".join(lines)


def _line(row: dict[str, str], titles: dict[str, str]) -> str:
    if not row["ours"]:
        sys.exit(f"{row['case']} could not be measured; the table stays as it is")
    unit = "" if row["unit"] == "–" else f" {row['unit']}"
    tolerance = f"{float(row['tolerance']):.2g}" if row["tolerance"] else ""
    return (f"| {titles[row['case']]} | {row['quantity']} | {row['kind']} "
            f"| {format_number(float(row['reference']))}{unit} "
            f"| {format_number(float(row['ours']))}{unit} "
            f"| {float(row['error']):.1e} | {tolerance} |")
