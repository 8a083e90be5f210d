"""report.html: every case with its text, its numbers and its plots, in one file."""

from __future__ import annotations

from html import escape
from itertools import groupby
from pathlib import Path

from case import Case, kKinds, Result, Row
from plots import draw
from results import format_number

kHead = ("<th>quantity</th><th>kind</th><th>unit</th><th class=n>reference</th>"
         "<th class=n>ours</th><th class=n>error</th><th class=n>tolerance</th>")


def write_report(path: Path, cases: list[Case], results: dict[str, Result | str]) -> None:
    css = Path(__file__).with_name("report.css").read_text(encoding="utf-8")
    body = [_introduction(results), _kinds(results), _thesis_table(cases, results),
            _summary(cases, results)]
    for section, members in groupby(cases, key=lambda case: case.section):
        body.append(f"<h2>{escape(section)}</h2>")
        body += [_article(case, results[case.name]) for case in members]
    path.write_text(
        "<!doctype html><html lang=en><meta charset=utf-8>"
        "<meta name=viewport content='width=device-width'>"
        f"<title>Plimsoll: validation</title><style>{css}</style>"
        f"<main>{''.join(body)}</main></html>\n", encoding="utf-8")


def _introduction(results: dict[str, Result | str]) -> str:
    broken = [name for name, result in results.items() if isinstance(result, str)]
    rows = [row for result in results.values() if isinstance(result, Result)
            for row in result.rows if row.tolerance is not None]
    failed = sum(not row.passed for row in rows)
    verdict = f"{len(rows) - failed} of {len(rows)} quantities within tolerance"
    if broken:
        verdict += f"; could not be measured: {', '.join(broken)}"
    bad = " bad" if failed or broken else ""
    return (
        "<h1>Plimsoll: validation</h1><p class=lead>How far each force and motion is from the "
        "truth. Every number under “ours” comes from running the program on the scene that is "
        "named; the references are exact, or their source is given. Errors are relative unless the "
        "case says otherwise. A row without a tolerance is shown, not judged.</p>"
        f"<div class='verdict{bad}'>{escape(verdict)}</div>")


def _kinds(results: dict[str, Result | str]) -> str:
    """The rule for the tolerance of each kind of row, and how many there are."""
    rows = [row for result in results.values() if isinstance(result, Result)
            for row in result.rows]
    lines = []
    for kind, rule in kKinds.items():
        members = [row for row in rows if row.kind == kind]
        passed = sum(row.passed for row in members)
        count = f"{len(members)}" if kind == "shown" else f"{passed} of {len(members)}"
        lines.append(f"<tr><td class=k>{kind}</td><td>{escape(rule)}</td>"
                     f"<td class=n>{count}</td></tr>")
    return ("<h2>How each row is judged</h2><article><table><tr><th>kind</th>"
            "<th>what it is, and the rule for its tolerance</th><th class=n>passed</th></tr>"
            f"{''.join(lines)}</table></article>")


def _cells(row: Row) -> str:
    error = "–" if row.error != row.error else f"{row.error:.2g}"
    tolerance = "" if row.tolerance is None else f"{row.tolerance:.2g}"
    return (f"<td>{escape(row.quantity)}</td><td class=k>{row.kind}</td>"
            f"<td class=u>{escape(row.unit)}</td>"
            f"<td class=n>{format_number(row.reference)}</td>"
            f"<td class=n>{format_number(row.ours)}</td>"
            f"<td class=n>{error}</td><td class=n>{tolerance}</td>{_verdict(row)}")


def _verdict(row: Row) -> str:
    if row.tolerance is None:
        return "<td class=shown>shown</td>"
    return "<td class=ok>pass</td>" if row.passed else "<td class=fail>fail</td>"


def _rows_of(case: Case, results: dict[str, Result | str]) -> list[Row]:
    result = results[case.name]
    return [] if isinstance(result, str) else result.rows


def _thesis_table(cases: list[Case], results: dict[str, Result | str]) -> str:
    """What the thesis printed beside what is right."""
    lines = [
        f"<tr><td><a href='#{case.name}'>{escape(case.title)}</a></td><td>{escape(row.quantity)}"
        f"</td><td class=n>{format_number(row.thesis)}</td>"
        f"<td class=n>{format_number(row.reference)}</td>"
        f"<td class=n>{format_number(row.ours)}</td><td class=n>{row.error:.2g}</td></tr>"
        for case in cases for row in _rows_of(case, results) if row.thesis is not None]
    if not lines:
        return ""
    return ("<h2>The thesis's numbers</h2><p class=lead>Chapter 4 of S. Ålstig Sandberg, "
            "Interactive simulation of hydrodynamics for arbitrarily shaped objects (2014). Its "
            "other experiments are figures without numbers; they are repeated below.</p>"
            "<article><table>"
            "<tr><th>case</th><th>quantity</th><th class=n>thesis</th><th class=n>exact</th>"
            f"<th class=n>ours</th><th class=n>our error</th></tr>{''.join(lines)}</table>"
            "</article>")


def _summary(cases: list[Case], results: dict[str, Result | str]) -> str:
    lines = [f"<tr><td><a href='#{case.name}'>{escape(case.title)}</a></td>{_cells(row)}</tr>"
             for case in cases for row in _rows_of(case, results) if row.headline]
    return (f"<h2>At a glance</h2><article><table><tr><th>case</th>{kHead}<th></th></tr>"
            f"{''.join(lines)}</table></article>")


def _article(case: Case, result: Result | str) -> str:
    scenes = ", ".join(f"<code>tools/run scenes/{escape(scene)}</code>" for scene in case.scenes)
    head = (f"<article id={case.name}><span class=name>{case.name}</span>"
            f"<h3>{escape(case.title)}</h3><p>{case.text}</p>"
            f"<p class=exact><b>Reference.</b> {case.exact}</p>"
            f"<p class=exact><b>See it.</b> {scenes}</p>")
    if isinstance(result, str):
        return f"{head}<pre>{escape(result)}</pre></article>"
    rows = "".join(f"<tr>{_cells(row)}</tr>" for row in result.rows)
    plots = "".join(f"<div>{draw(plot)}</div>" for plot in result.plots)
    return (f"{head}<table><tr>{kHead}<th></th></tr>{rows}</table>"
            f"<div class=plots>{plots}</div></article>")
