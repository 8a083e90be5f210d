"""Tables in pages of Markdown that are generated from measurements, each between two marks."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path


def rewrite_marked(page: Path, name: str, lines: Iterable[str]) -> None:
    """Replaces the lines between <!-- NAME:begin --> and <!-- NAME:end -->."""
    begin, end = f"<!-- {name}:begin -->", f"<!-- {name}:end -->"
    text = page.read_text(encoding="utf-8")
    if text.count(begin) != 1 or text.count(end) != 1 or text.index(begin) > text.index(end):
        sys.exit(f"{page} lacks the marks {begin} and {end}, once each and in this order")
    before, rest = text.split(begin)
    page.write_text("\n".join([before + begin, *lines, end]) + rest.split(end)[1],
                      encoding="utf-8")


def table_lines(header: Iterable[str], rows: Iterable[Iterable[str]], words: int) -> list[str]:
    """The lines of a table in Markdown. The columns after the first `words` hold numbers and are
    aligned to the right."""
    header = tuple(header)
    rule = ("---",) * words + ("---:",) * (len(header) - words)
    return ["| " + " | ".join(line) + " |" for line in (header, rule, *rows)]
