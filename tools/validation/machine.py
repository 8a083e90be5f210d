"""The machine that something was measured on, as results name it."""

from __future__ import annotations

import os
import platform
from pathlib import Path


def processors() -> int:
    """That this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def cpu_name() -> str:
    """As the system names it."""
    path = Path("/proc/cpuinfo")
    lines = path.read_text(encoding="utf-8").splitlines() if path.is_file() else []
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()


def this_machine() -> dict:
    """With the load that others put on it as the measurement starts."""
    return {"cpu": cpu_name(), "processors": processors(),
            "system": f"{platform.system()} {platform.machine()}",
            "load_average": os.getloadavg()[0]}
