"""Tables in README.md that are made from measurements, each between its two marks."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path


def rewrite_marked(readme: Path, name: str, lines: Iterable[str]) -> None:
    """What stands between <!-- NAME:begin --> and <!-- NAME:end -->."""
    begin, end = f"<!-- {name}:begin -->", f"<!-- {name}:end -->"
    text = readme.read_text(encoding="utf-8")
    if text.count(begin) != 1 or text.count(end) != 1 or text.index(begin) > text.index(end):
        sys.exit(f"{readme} lacks the marks {begin} and {end}, once each and in this order")
    before, rest = text.split(begin)
    readme.write_text("\n".join([before + begin, *lines, end]) + rest.split(end)[1],
                      encoding="utf-8")


def table_lines(header: Iterable[str], rows: Iterable[Iterable[str]], words: int) -> list[str]:
    """Of a table in Markdown; all columns but the first `words` are numbers, set to the right."""
    header = tuple(header)
    rule = ("---",) * words + ("---:",) * (len(header) - words)
    return ["| " + " | ".join(line) + " |" for line in (header, rule, *rows)]
