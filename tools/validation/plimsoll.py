"""Runs the program and reads what it says."""

from __future__ import annotations

import csv
import json
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np


kNone = "none"  # As a value in a scene: the word.


class ProgramError(RuntimeError):
    """The program ended with an error; its message and exit code."""

    def __init__(self, message: str, code: int):
        super().__init__(message)
        self.code = code


@dataclass(frozen=True)
class Load:
    force: np.ndarray  # N, world axes.
    torque: np.ndarray  # N m, about the centre of mass, world axes.


@dataclass(frozen=True)
class Body:
    """What `probe` says of a body in its initial state; SI, world axes."""

    com: np.ndarray
    mass: float
    inertia: np.ndarray
    volume: float  # Displaced.
    buoyancy: Load
    pressure_drag: Load
    viscous_drag: Load
    lift: Load
    wave_inertia: Load
    diffraction: Load
    wind: Load
    added_mass: np.ndarray | None  # 6 x 6, about the centre of mass; None without a model.


@dataclass(frozen=True)
class Track:
    """The states of a body over time, one row a time; SI, world axes."""

    t: np.ndarray
    position: np.ndarray  # Of the centre of mass.
    quaternion: np.ndarray  # w, x, y, z: body to world.
    velocity: np.ndarray
    angular_velocity: np.ndarray


def _load(entry: dict) -> Load:
    return Load(np.array(entry["force"]), np.array(entry["torque"]))


def _body(entry: dict) -> Body:
    return Body(
        com=np.array(entry["com"]), mass=entry["mass"], inertia=np.array(entry["inertia"]),
        volume=entry["displaced_volume"],
        added_mass=None if entry["added_mass"] is None else np.array(entry["added_mass"]),
        **{name: _load(entry[name])
           for name in ("buoyancy", "pressure_drag", "viscous_drag", "lift", "wave_inertia",
                        "diffraction", "wind")})


def _set_options(overrides: dict) -> list[str]:
    """Values are written as JSON, which is YAML too; a text stands without quotes."""
    options = []
    for path, value in overrides.items():
        text = value if isinstance(value, str) else json.dumps(value)
        options += ["--set", f"{path}={text}"]
    return options


class Plimsoll:
    """The program, the scenes that it runs, and the folder in which a case may write. Without an
    environment it has that of this process."""

    def __init__(self, program: Path, scenes: Path, work: Path,
                 environment: dict[str, str] | None = None):
        self.program = program
        self.scenes = scenes
        self.work = work
        self._environment = environment

    def _call(self, *arguments: str) -> str:
        result = subprocess.run([str(self.program), *arguments], capture_output=True, text=True,
                                check=False, env=self._environment)
        if result.returncode != 0:
            raise ProgramError(f"plimsoll {' '.join(arguments)}\nended with "
                               f"{result.returncode}:\n{result.stderr.strip()}",
                               result.returncode)
        return result.stdout

    def _scene(self, scene: str | Path) -> str:
        return str(scene if isinstance(scene, Path) else self.scenes / scene)

    def probe(self, scene: str | Path, overrides: dict | None = None) -> dict[str, Body]:
        """The loads on every body; a text names a scene below scenes/."""
        text = self._call("probe", self._scene(scene), *_set_options(overrides or {}))
        return {name: _body(entry) for name, entry in json.loads(text)["bodies"].items()}

    def probe_one(self, scene: str | Path, overrides: dict | None = None) -> Body:
        return next(iter(self.probe(scene, overrides).values()))

    def hydrostatics(self, scene: str | Path, overrides: dict | None = None,
                     heels: str = "0:30:5") -> dict:
        """How the scene's only body floats, as the program prints it; heels as FIRST:LAST:STEP."""
        text = self._call("hydrostatics", self._scene(scene), "--heel", heels, "--json",
                          *_set_options(overrides or {}))
        return next(iter(json.loads(text)["bodies"].values()))

    def added_mass(self, file: Path, *options: str) -> dict:
        """Of a mesh file's or scene's only body, wholly submerged and solved anew, as the program
        prints it: SI, body axes, about the centre of mass."""
        text = self._call("addedmass", str(file), "--json", "--no-store", *options)
        return next(iter(json.loads(text)["bodies"].values()))

    def radiation(self, scene: Path, frequencies: list[float]) -> dict:
        """Waves that the scene's only body makes and scatters, as the program prints them."""
        text = self._call("radiation", str(scene), "--json", "--frequencies",
                          *(f"{frequency:.12g}" for frequency in frequencies))
        return next(iter(json.loads(text)["bodies"].values()))

    def run(self, scene: str | Path, name: str,
            overrides: dict | None = None) -> tuple[dict[str, Track], dict]:
        """Trajectories by body, and the summary; `name` is the folder of the run."""
        out = self.work / name
        self._call("run", self._scene(scene), "--out", str(out), "--no-render", "--quiet",
                   "--threads", "1", *_set_options(overrides or {}))
        return self.tracks(name), json.loads((out / "summary.json").read_text())

    def tracks(self, name: str) -> dict[str, Track]:
        """Trajectories of an earlier run by body."""
        return _tracks(self.work / name / "trajectory.csv")

    def run_one(self, scene: str | Path, name: str, overrides: dict | None = None) -> Track:
        return next(iter(self.run(scene, name, overrides)[0].values()))

    def write_scene(self, name: str, scene: dict) -> Path:
        """A scene made by a case, in its folder."""
        self.work.mkdir(parents=True, exist_ok=True)
        path = self.work / f"{name}.yaml"
        path.write_text(json.dumps(scene).replace(f'"{kNone}"', kNone))
        return path


def _tracks(path: Path) -> dict[str, Track]:
    rows: dict[str, list[list[float]]] = {}
    with open(path, newline="", encoding="utf-8") as file:
        lines = csv.reader(file)
        next(lines)
        for time, body, *state in lines:
            rows.setdefault(body, []).append([float(time), *map(float, state)])
    return {body: _track(np.array(table)) for body, table in rows.items()}


def _track(table: np.ndarray) -> Track:
    return Track(table[:, 0], table[:, 1:4], table[:, 4:8], table[:, 8:11], table[:, 11:14])


def body_axis(quaternion: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """A body axis in the world, for each row of quaternions."""
    w, v = quaternion[:, :1], quaternion[:, 1:]
    u = np.broadcast_to(axis, v.shape)
    t = 2 * np.cross(v, u)
    return u + w * t + np.cross(v, t)
