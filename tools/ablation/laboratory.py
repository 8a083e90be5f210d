"""Runs of scenes and of the stress test with some of the engine's constants changed."""

from __future__ import annotations

import csv
import json
import os
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from constants import kPrefix
from plimsoll import Plimsoll, ProgramError, Track

kFinerBy = 8  # Steps of the reference in one of the scene.
kRows = 0.1  # Time between compared rows [s].


@dataclass(frozen=True)
class Variant:
    """The engine with some constants changed."""

    name: str  # Also of its folder.
    values: tuple[tuple[str, str], ...] = ()  # Constants and their values.

    def environment(self) -> dict[str, str]:
        return {**os.environ, **{kPrefix + name: value for name, value in self.values}}

    def mark(self) -> str:
        return " ".join("=".join(pair) for pair in self.values)


kUnchanged = Variant("unchanged")


@dataclass(frozen=True)
class Scene:
    name: str  # Below scenes/, without .yaml.
    seconds: float  # Of it that are simulated.


@dataclass(frozen=True)
class SceneResult:
    error: float | None  # Against the reference [m]; None: not known.
    same: bool  # The bytes of the unchanged engine.
    stopped: bool = False  # Before its end.


@dataclass(frozen=True)
class StressResult:
    runs: int
    failed: int
    changed: int  # Runs whose last states are not those of the unchanged engine.
    unconverged: int  # Substeps.
    clamped: int  # Substeps.


class Laboratory:
    """Keeps its runs in a folder; a run that is there from the same program is not done again."""

    def __init__(self, programs: Path, scenes: Path, work: Path, tell):
        self._program = programs / "plimsoll"
        self._stress = programs / "plimsoll_stress"
        self._scenes = scenes
        self._work = work
        self._tell = tell

    def scene_results(self, scene: Scene, variants: list[Variant],
                      jobs: int) -> dict[str, SceneResult]:
        """By the variants' names, the unchanged engine first. Where all have its bytes no reference
        is computed, and errors are None."""
        plain = self._run(scene, kUnchanged, {"log.every": kRows})
        if plain is None:
            raise SystemExit(f"{scene.name} does not run to its end with the unchanged engine")
        with ThreadPoolExecutor(jobs) as pool:
            runs = dict(zip(variants, pool.map(
                lambda variant: self._run(scene, variant, {"log.every": kRows}), variants)))
        same = {variant: runs[variant] is not None and self._bytes(scene, variant) ==
                self._bytes(scene, kUnchanged) for variant in variants}
        if all(same.values()):
            return {variant.name: SceneResult(None, True) for variant in [kUnchanged, *variants]}
        reference = self._reference(scene)
        results = {kUnchanged.name: SceneResult(error_of(plain, reference), True)}
        for variant, tracks in runs.items():
            error = None if tracks is None else error_of(tracks, reference)
            results[variant.name] = SceneResult(error, same[variant], stopped=tracks is None)
        return results

    def stress_results(self, variants: list[Variant], choice: list[str],
                       jobs: int) -> dict[str, StressResult]:
        """Of the runs inside the operating envelope, of those that `choice` asks for."""
        every = self._stress_rows(kUnchanged, choice, jobs)
        inside = {run: row for run, row in every.items() if row["inside"] == "1"}
        listed = self._work / "inside.txt"
        listed.write_text("".join(run + "\n" for run in inside))
        results = {kUnchanged.name: _stress_result(inside, inside)}
        for variant in variants:
            rows = self._stress_rows(variant, ["--only", str(listed)], jobs)
            results[variant.name] = _stress_result(rows, inside)
        return results

    def _folder(self, scene: Scene, variant: Variant) -> Path:
        return self._work / variant.name / scene.name

    def _bytes(self, scene: Scene, variant: Variant) -> bytes:
        return (self._folder(scene, variant) / "trajectory.csv").read_bytes()

    def _reference(self, scene: Scene) -> dict[str, Track]:
        """Of the unchanged engine at an eighth of the step."""
        summary = self._folder(scene, kUnchanged) / "summary.json"
        told = json.loads(summary.read_text())
        step = told["simulated_seconds"] / told["steps"]
        tracks = self._run(scene, Variant("reference"), {"step": step / kFinerBy,
                                                         "log.every": step})
        if tracks is None:
            raise SystemExit(f"{scene.name} does not run to its end at an eighth of its step")
        return tracks

    def _run(self, scene: Scene, variant: Variant, keys: dict) -> dict[str, Track] | None:
        """None if the motion was given up."""
        folder = self._folder(scene, variant)
        program = self._program.stat()
        keys = {"duration": scene.seconds, **keys}
        mark = f"{program.st_size} {program.st_mtime_ns} {keys} {variant.mark()}"
        stamp = folder / "ablation.txt"
        plimsoll = Plimsoll(self._program, self._scenes, folder.parent, variant.environment())
        if stamp.is_file() and stamp.read_text() == mark:
            return plimsoll.tracks(folder.name)
        self._tell(f"{scene.name}: {variant.name}")
        shutil.rmtree(folder, ignore_errors=True)
        folder.parent.mkdir(parents=True, exist_ok=True)
        try:
            tracks, _ = plimsoll.run(f"{scene.name}.yaml", folder.name, keys)
        except ProgramError as error:
            if error.code != 3:
                raise
            return None
        stamp.write_text(mark)
        return tracks

    def _stress_rows(self, variant: Variant, choice: list[str], jobs: int) -> dict[str, dict]:
        self._tell(f"stress: {variant.name}")
        out = self._work / variant.name / "stress"
        known = out / "choice.txt"
        mark = " ".join(choice) + "\n" + variant.mark()
        if known.is_file() and known.read_text() != mark:
            shutil.rmtree(out)
        out.mkdir(parents=True, exist_ok=True)
        known.write_text(mark)
        process = subprocess.run([str(self._stress), *choice, "--jobs", str(jobs), "--out", str(out)],
                                 env=variant.environment(), stdout=subprocess.DEVNULL, check=False)
        if process.returncode not in (0, 1):
            raise SystemExit(f"{self._stress} ended with {process.returncode}")
        with open(out / "stress.csv", encoding="utf-8") as file:
            next(file)  # What the program was.
            return {row["run"]: row for row in csv.DictReader(file)}


def error_of(tracks: dict[str, Track], reference: dict[str, Track]) -> float:
    """Mean over the bodies of the root mean square distance of their places [m]."""
    errors = []
    for body, track in tracks.items():
        fine = reference[body]
        at = np.searchsorted(fine.t, track.t - 1e-9 * (1 + track.t))
        if at.max() >= len(fine.t) or np.abs(fine.t[at] - track.t).max() > 1e-6:
            raise SystemExit(f"the reference of {body} has not the same times")
        offset = np.linalg.norm(track.position - fine.position[at], axis=1)
        errors.append(np.sqrt(np.mean(offset**2)))
    return float(np.mean(errors))


def _stress_result(rows: dict[str, dict], unchanged: dict[str, dict]) -> StressResult:
    return StressResult(
        runs=len(rows), failed=sum(bool(row["fault"]) for row in rows.values()),
        changed=sum(row["digest"] != unchanged[run]["digest"] for run, row in rows.items()),
        unconverged=sum(int(row["unconverged"]) for row in rows.values()),
        clamped=sum(int(row["clamped"]) for row in rows.values()))
