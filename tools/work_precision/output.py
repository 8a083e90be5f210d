"""Results as JSON, as CSV, as a table on the terminal and in tests/benchmarks/README.md."""

from __future__ import annotations

import csv
import json
from dataclasses import asdict, fields
from pathlib import Path

from judgement import Judgement, Ratio, judge
from marked import rewrite_marked, table_lines
from studies import Finding, Row

kMethods = ("baseline", "default", "tolerance")


def write_results(folder: Path, findings: list[Finding], machine: dict) -> None:
    rows = [asdict(row) for finding in findings for row in finding.rows]
    with open(folder / "results.csv", "w", newline="", encoding="utf-8") as file:
        lines = csv.DictWriter(file, [field.name for field in fields(Row)], lineterminator="\n")
        lines.writeheader()
        lines.writerows(rows)
    content = {"machine": machine, "experiments": [_experiment(f) for f in findings],
               "runs": rows}
    (folder / "results.json").write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")


def _experiment(finding: Finding) -> dict:
    return {"name": finding.experiment.name, "title": finding.experiment.title,
            "scene": finding.experiment.scene, "smooth": finding.experiment.smooth,
            "length": finding.experiment.length, "reference": finding.reference,
            "reference_doubt": finding.doubt, "cross_check": finding.cross_check,
            "cross_check_doubt": finding.cross_doubt,
            "references_agree": finding.references_agree,
            "judgements": [_judgement(judge(finding, method)) for method in kMethods]}


def _judgement(judgement: Judgement) -> dict:
    return {"method": judgement.method, "order": judgement.order, "target": judgement.target,
            "baseline_seconds": judgement.baseline_seconds,
            "error_ratio": _ratio(judgement.error_ratio),
            "speed_ratio": _ratio(judgement.speed_ratio)}


def _ratio(ratio: Ratio | None) -> dict | None:
    return {"value": ratio.value, "at_least": ratio.at_least} if ratio else None


kHeader = ("scene", "reference", "doubt", "check", "order plain", "order default",
           "error at", "plain's time", "default: error", "time", "tolerance: error", "time")


def table(findings: list[Finding]) -> list[tuple[str, ...]]:
    """Rows of words under kHeader; ratios are the plain method's over ours."""
    return [_words(finding) for finding in findings if finding.rows]


def _words(finding: Finding) -> tuple[str, ...]:
    plain, default, tolerance = (judge(finding, method) for method in kMethods)
    agree = {None: "–", True: f"{finding.cross_check or 0:.1e}",
             False: f"{finding.cross_check or 0:.1e} !"}[finding.references_agree]
    return (finding.experiment.title, finding.reference,
            f"{finding.doubt:.1e}" if finding.doubt else "–", agree,
            _number(plain.order, ".2f"), _number(default.order, ".2f"),
            _number(plain.target, ".1e"), _seconds(plain.baseline_seconds),
            _times(default.error_ratio), _times(default.speed_ratio),
            _times(tolerance.error_ratio), _times(tolerance.speed_ratio))


def _number(value: float | None, form: str) -> str:
    return "–" if value is None else format(value, form)


def _seconds(value: float | None) -> str:
    return "–" if value is None else f"{value * 1e3:.3g} ms"


def _times(ratio: Ratio | None) -> str:
    return "–" if ratio is None else f"{ratio} ×"


def print_table(findings: list[Finding]) -> None:
    lines = [kHeader, *table(findings)]
    widths = [max(len(line[i]) for line in lines) for i in range(len(kHeader))]
    for line in lines:
        print("  ".join(word.ljust(width) if i < 2 else word.rjust(width)
                        for i, (word, width) in enumerate(zip(line, widths))))
    for finding in findings:
        if finding.references_agree is False:
            print(f"{finding.experiment.title}: two methods tend to limits that are "
                  f"{finding.cross_check:.1e} apart, more than they are in doubt by")


def rewrite_page(page: Path, findings: list[Finding]) -> None:
    """The table between its two marks."""
    rewrite_marked(page, "work-precision", table_lines(kHeader, table(findings), words=2))
