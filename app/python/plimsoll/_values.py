"""Values of Python as those of a scene."""

import numbers
import os
from typing import Any


def plain(value: Any) -> Any:
    """Return a value made of dicts, lists, texts and Python's numbers alone.

    Raises TypeError for what a scene cannot hold.
    """
    if value is None or isinstance(value, (str, bool, int, float)):
        return value
    if isinstance(value, dict):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist"):  # NumPy's arrays, numbers and truths
        return plain(value.tolist())
    if isinstance(value, numbers.Real):
        return float(value)
    raise TypeError(f"a scene holds no {type(value).__name__}: {value!r}")
