"""The reference values that are not computed here: reference_values.csv, with its sources."""

from __future__ import annotations

import csv
from functools import lru_cache
from pathlib import Path


@lru_cache
def _table() -> dict[str, float]:
    path = Path(__file__).with_name("reference_values.csv")
    with open(path, newline="", encoding="utf-8") as file:
        return {row["key"]: float(row["value"]) for row in csv.DictReader(file)}


def value(key: str) -> float:
    return _table()[key]
