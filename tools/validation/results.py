"""results.csv: one line a compared quantity."""

from __future__ import annotations

import csv
import math
from pathlib import Path

from case import Result

kColumns = ("case", "quantity", "reference", "ours", "error", "tolerance", "unit", "thesis",
            "passed", "headline", "kind")


def write_csv(path: Path, results: dict[str, Result | str]) -> None:
    """Numbers read back to the same double; an empty tolerance: shown, not judged. A case that
    broke has one line without numbers."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow(kColumns)
        for name, result in results.items():
            if isinstance(result, str):
                lines.writerow([name, "the case could not be measured", "", "", "", "", "", "",
                                "no", "yes", ""])
                continue
            for row in result.rows:
                lines.writerow([
                    name, row.quantity, repr(row.reference), repr(row.ours), repr(row.error),
                    "" if row.tolerance is None else repr(float(row.tolerance)), row.unit,
                    "" if row.thesis is None else repr(row.thesis),
                    "yes" if row.passed else "no", "yes" if row.headline else "no",
                    row.kind])


def format_number(value: float) -> str:
    """Six digits, for people; powers of ten only where they are needed."""
    if math.isnan(value):
        return "–"
    if value == 0 or 1e-3 <= abs(value) < 1e6:
        return f"{value:.6g}"
    return f"{value:.3g}"
