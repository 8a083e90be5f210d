"""Works through a task of scenes/GUIDE.md and keeps what it wrote and printed."""
from __future__ import annotations

import csv
import shlex
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

kRoot = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(kRoot / "tests/documentation"))

from documented_scenes import lay_out, missing_of, take  # noqa: E402  The path is set first.
from machine import Machine  # noqa: E402


class LeftOut(Exception):
    """This machine lacks what a picture needs."""


@dataclass
class Work:
    """A task whose files were written and whose commands were run."""

    steps: list
    machine: Machine
    folder: Path
    printed: list  # Output of each command, in their order.

    def run(self, *words: str, text: str | None = None, codes: tuple = (0,)) -> str:
        """Runs a command and returns what it prints."""
        ended = self.machine.run(list(words), self.folder, text)
        if ended.returncode not in codes:
            raise RuntimeError(f"{shlex.join(words)}: ended with {ended.returncode}\n{ended.stdout}")
        return ended.stdout

    def run_scene(self, scene: str, *changes: str, out: str | None = None) -> Path:
        """Runs a scene, without pictures, and returns the folder of the run."""
        out = out or f"out/{Path(scene).stem}"
        self.run("plimsoll", "run", scene, "--no-render", "--out", out, *set_words(changes))
        return self.folder / out

    def stop(self, scene: str, out: str, seconds: float) -> float:
        """Runs a scene and ends it, as Ctrl-C would, after some time. Returns how far it came [s]."""
        words = ["plimsoll", "run", scene, "--out", out, "--checkpoint", "60", "--no-render", "--quiet"]
        with subprocess.Popen(words, cwd=self.folder, env=self.machine.environment) as running:
            time.sleep(seconds)
            running.terminate()
        return self.table(f"{out}/trajectory.csv")["time"][-1]

    def continue_python(self, more: str) -> str:
        """Runs the task's Python and more of it in one go, and returns what they print."""
        snippet = next(step for step in self.steps if step.kind == "python")
        return self.run(sys.executable, "-B", "-", text=snippet.text + more)

    def table(self, name: str, **chosen: str) -> dict[str, np.ndarray]:
        """The columns of a CSV file, with the rows that have these values, such as body="barge"."""
        with open(self.folder / name, encoding="utf-8", newline="") as file:
            rows = [row for row in csv.DictReader(file)
                    if all(row[column] == value for column, value in chosen.items())]
        return {column: np.array([number(row[column]) for row in rows]) for column in rows[0]}


def number(text: str) -> float:
    """NaN where a cell is empty or no number."""
    try:
        return float(text)
    except ValueError:
        return float("nan")


def set_words(changes) -> list[str]:
    return [word for change in changes for word in ("--set", change)]


def whole(command: str) -> list[str]:
    """A command as it is run for a picture: to its end, but without pictures and videos of its own,
    which are drawn from the run."""
    words = shlex.split(command)
    if words[:2] != ["plimsoll", "run"]:
        return words
    if "--video" in words:
        place = words.index("--video")
        del words[place:place + 2]
    drawn = [] if "--no-render" in words else ["--no-render"]
    return [*words, *drawn]


def work_through(steps: list, machine: Machine, folder: Path) -> Work:
    """Writes the files of a task and runs its commands in a folder of its own. Python is left to the
    picture."""
    lay_out(folder)
    work = Work(steps, machine, folder, [])
    for step in steps:
        lacking = missing_of(step, machine) - {"ffmpeg"}
        if lacking:
            raise LeftOut(f"no {', '.join(sorted(lacking))}")
        if step.kind == "run":
            work.printed.append(work.run(*whole(step.text), codes=(step.code,)))
        elif step.kind not in ("python", "cpp"):
            take(step, machine, folder)
    return work
