"""Runs of the program: the trajectory that each gives and the time that its physics takes.

The program's own clocks count the wall time of its physics; the system counts the processor time of
the whole process. Both are taken without those of a run of one step, which is the setting up. On
one thread both are then the same but for what else the machine does meanwhile, which makes the
wall time of long runs too large, and for the unsteady start of a process, which blurs the
processor time of short ones: so it is the wall time for short runs and the lesser for others."""

from __future__ import annotations

import functools
import json
import resource
import shutil
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from experiments import Experiment, Measured, Mesh, kLogEvery
from plimsoll import Plimsoll, ProgramError, Track
from trajectory_error import Path

kLongEnough = 0.5  # After so much time its repeats have told a run's least time [s].
kShort = 0.01  # Wall time of runs that the processor time is too blurred for [s].


@dataclass(frozen=True)
class Method:
    name: str
    keys: dict  # Of the scene, that choose it.


kBaseline = Method("baseline", {"integrator.method": "ode"})
kDefault = Method("default", {})


def with_tolerance(tolerance: float) -> Method:
    return Method("tolerance", {"integrator.tolerance": tolerance})


@dataclass(frozen=True)
class Run:
    """One way to compute a scene."""

    experiment: Experiment
    method: Method
    mesh: Mesh
    rate: int  # Steps in a second.

    @property
    def tolerance(self) -> float | None:
        return self.method.keys.get("integrator.tolerance")

    def words(self) -> str:
        finer = "" if self.tolerance is None else f" {self.tolerance:g}"
        return (f"{self.experiment.name}: {self.method.name}{finer}, step 1/{self.rate} s, "
                f"{self.mesh.triangles} triangles")

    def keys(self) -> dict:
        return {"step": 1 / self.rate, "log.every": kLogEvery, **self.experiment.keys,
                **self.mesh.keys, **self.method.keys}


@dataclass(frozen=True)
class Cost:
    wall: float  # Of the physics [s].
    processor: float  # Of the whole process [s].

    def least(self, other: Cost) -> Cost:
        return Cost(min(self.wall, other.wall), min(self.processor, other.processor))

    def seconds_of(self, steps: int, start_up: Cost) -> float:
        """Of the physics, as if every step cost as much as those after the first."""
        part = steps / (steps - 1) if steps > 1 else 0.0
        wall, processor = self.wall - start_up.wall, self.processor - start_up.processor
        blurred = wall < kShort or processor < kShort / 2
        return part * max(0.0, wall if blurred else min(wall, processor))


@dataclass
class Outcome:
    run: Run
    path: Path | None  # None: the motion grew beyond all bounds.
    steps: int
    cost: Cost  # The least of its repeats.
    seconds: float = 0.0  # Of the physics, without the first step's setting up.


class Laboratory:
    """Runs the program, one run at a time and on one thread, and repeats runs to time them."""

    def __init__(self, plimsoll: Plimsoll, repeats: int, tell: Callable[[str], None]):
        self._plimsoll = plimsoll
        self._repeats = repeats
        self._tell = tell
        self._start_up: dict[tuple, Cost] = {}

    def measured(self, runs: list[Run], timed: bool = True) -> list[Outcome]:
        """The runs in turns, so that what else the machine does does not meet all repeats of one.
        A run that differs from its repeat is an error: the program is deterministic."""
        outcomes = [self._once(run) for run in runs]
        for count in range(1, self._repeats if timed else 1):
            for outcome in outcomes:
                if outcome.path is not None and outcome.cost.wall * count < kLongEnough:
                    self._repeat(outcome)
        for outcome in outcomes if timed else []:
            outcome.seconds = outcome.cost.seconds_of(outcome.steps, self._start_up_of(outcome.run))
        return outcomes

    def _repeat(self, outcome: Outcome) -> None:
        again = self._once(outcome.run)
        if not _same(again.path, outcome.path):
            raise RuntimeError(f"two equal runs of {outcome.run.experiment.name} differ")
        outcome.cost = outcome.cost.least(again.cost)

    def probe(self, experiment: Experiment, mesh: Mesh) -> Measured:
        """Of the experiment's only body, sinking at 1 m/s."""
        body = self._plimsoll.probe_one(experiment.scene, {
            **experiment.keys, **mesh.keys, "bodies[0].linear_velocity": [0, 0, -1]})
        return Measured(body.mass, body.volume, body.pressure_drag.force[2])

    def _once(self, run: Run) -> Outcome:
        self._tell(run.words())
        tracks, steps, cost = self._timed(run.experiment, run.keys())
        return Outcome(run, None if tracks is None else _path(tracks), steps, cost)

    def _timed(self, experiment: Experiment,
               keys: dict) -> tuple[dict[str, Track] | None, int, Cost]:
        """Tracks, steps and what they cost."""
        before = _processor_seconds()
        tracks, summary = self._run(experiment, keys)
        cost = Cost(_physics_seconds(summary), _processor_seconds() - before)
        return tracks, summary["steps"], cost

    def _run(self, experiment: Experiment, keys: dict) -> tuple[dict[str, Track] | None, dict]:
        """No tracks if the program gave the motion up as not finite; other errors are raised."""
        folder = self._plimsoll.work / "run"
        shutil.rmtree(folder, ignore_errors=True)
        try:
            return self._plimsoll.run(experiment.scene, "run", keys)
        except ProgramError:
            file = folder / "summary.json"
            summary = json.loads(file.read_text()) if file.is_file() else {}
            if summary.get("ended") != "failed":
                raise
            return None, summary

    def _start_up_of(self, run: Run) -> Cost:
        """Of a run of one step, the least of some."""
        key = (run.experiment.name, run.mesh.triangles, *run.method.keys.items())
        if key not in self._start_up:
            keys = {**run.keys(), "duration": 1 / run.rate}
            costs = [self._timed(run.experiment, keys)[2] for _ in range(self._repeats)]
            self._start_up[key] = functools.reduce(Cost.least, costs)
        return self._start_up[key]


def _same(a: Path | None, b: Path | None) -> bool:
    return (a is not None and b is not None and np.array_equal(a.position, b.position)
            and np.array_equal(a.attitude, b.attitude))


def _physics_seconds(summary: dict) -> float:
    wall = summary["wall_seconds"]
    return wall["collision"] + wall["hydro"] + wall["engine"]


def _processor_seconds() -> float:
    """Of all programs that were run and have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def _path(tracks: dict[str, Track]) -> Path:
    """Without the start, which all have in common."""
    bodies = list(tracks.values())
    return Path(bodies[0].t[1:], np.array([body.position[1:] for body in bodies]),
                np.array([body.quaternion[1:] for body in bodies]))
