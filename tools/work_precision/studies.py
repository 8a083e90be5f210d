"""What is measured of one experiment: the error of time, of mesh and of the clip, and run times.

The error of time compares runs on one mesh with the motion that ever smaller steps tend to on that
mesh, or with the exact one. The error of the mesh compares that limit with the exact shape's
motion, or runs of one step with that on the finest mesh. On meshes of the same flat faces only the
cut at the water surface differs: the error of the clip, in still water nothing but round-off."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from experiments import Experiment, Mesh
from measurement import Laboratory, Method, Outcome, Run, kBaseline, kDefault, with_tolerance
from trajectory_error import Path, Reference, limit_of_steps, trajectory_error

kOrder = {"baseline": 1, "default": 2}  # Of a method on smooth motions.


@dataclass(frozen=True)
class Plan:
    """How much is measured."""

    rates: tuple[int, ...]  # Steps in a second, each twice the one before.
    further: int  # Doublings beyond them on the nominal mesh, for references.
    further_with_impacts: int
    tolerances: tuple[float, ...]
    tolerance_rate: int
    tolerance_rate_with_impacts: int
    mesh_rate: int  # For meshes that are compared with each other at one step.
    most_triangles: int
    repeats: int

    def all_rates(self, experiment: Experiment) -> list[int]:
        more = self.further if experiment.smooth else self.further_with_impacts
        return [*self.rates, *(self.rates[-1] * 2**i for i in range(1, more + 1))]

    def meshes(self, experiment: Experiment) -> list[Mesh]:
        return [mesh for mesh in experiment.meshes if mesh.triangles <= self.most_triangles]


@dataclass(frozen=True)
class Row:
    """One run and its errors, each as trajectory_error counts; None: not known, as of a run that
    diverged or is the reference itself."""

    experiment: str
    study: str  # time, pairs or mesh.
    method: str
    tolerance: float | None
    rate: int  # Steps in a second.
    triangles: int
    steps: int
    diverged: bool
    error_time: float | None  # Against the limit of small steps on the same mesh.
    error_mesh: float | None  # Of the mesh alone, or of the clip.
    error_total: float | None  # Against the exact shape.
    seconds: float | None  # Of physics.


@dataclass
class Finding:
    """An experiment's rows, and how far its reference is to be trusted."""

    experiment: Experiment
    reference: str = ""  # What it is, in words.
    doubt: float = 0.0  # Its own estimated error; 0 for an exact one.
    cross_check: float | None = None  # How far the other method's limit is from it,
    cross_doubt: float | None = None  # and by how much that limit is in doubt.
    rows: list[Row] = field(default_factory=list)

    @property
    def floor(self) -> float:
        """Errors below ten times the reference's tell as much of the reference as of the run."""
        return max(10 * self.doubt, 1e-12)

    @property
    def references_agree(self) -> bool | None:
        """Within twice what both are in doubt by. None: there is but one."""
        if self.cross_check is None:
            return None
        return self.cross_check <= 2 * (self.doubt + self.cross_doubt) + 1e-12


def study(laboratory: Laboratory, experiment: Experiment, plan: Plan, finding: Finding) -> None:
    """Adds to the finding stage by stage: what an interruption leaves is whole."""
    methods = [kBaseline, kDefault] if experiment.baseline else [kDefault]
    mesh = experiment.meshes[experiment.nominal]
    series = {method.name: _series(laboratory, experiment, method, mesh,
                                   plan.all_rates(experiment)) for method in methods}
    reference = _find_reference(laboratory, experiment, mesh, series, finding)
    for outcomes in series.values():
        finding.rows += [_row("time", outcome, reference.path) for outcome in outcomes]
    _study_tolerances(laboratory, experiment, plan, reference.path, finding)
    if experiment.all_pairs:
        _study_pairs(laboratory, experiment, plan, finding)
    elif experiment.mesh_kind:
        _study_meshes(laboratory, experiment, plan, finding)


def _series(laboratory: Laboratory, experiment: Experiment, method: Method, mesh: Mesh,
            rates: list[int]) -> list[Outcome]:
    return laboratory.measured([Run(experiment, method, mesh, rate) for rate in rates])


def _limit(outcomes: list[Outcome], smooth: bool, length: float) -> Reference | None:
    """Of the three smallest steps. None: they diverged."""
    paths = [outcome.path for outcome in outcomes[-3:]]
    if len(paths) < 3 or any(path is None for path in paths):
        return None
    last = outcomes[-1].run
    kind = f"{last.method.name}, step 1/{last.rate} s" + (", extrapolated" if smooth else "")
    return limit_of_steps(paths, kOrder[last.method.name] if smooth else None, length, kind)


def _exact(laboratory: Laboratory, experiment: Experiment, mesh: Mesh,
           times: np.ndarray) -> Path | None:
    """The exact motion on this mesh, if it is known."""
    if experiment.exact is None:
        return None
    body = laboratory.probe(experiment, mesh) if experiment.needs_probe else None
    return experiment.exact(times, body)


def _find_reference(laboratory: Laboratory, experiment: Experiment, mesh: Mesh,
                    series: dict[str, list[Outcome]], finding: Finding) -> Reference:
    """The exact motion or the default method's limit; the plain method's limit checks it, or that
    of the default where there is no other."""
    limits = {name: _limit(outcomes, experiment.smooth, experiment.length)
              for name, outcomes in series.items()}
    own = limits["default"]
    if own is None:
        raise RuntimeError(f"{experiment.name} diverges at the smallest steps")
    exact = _exact(laboratory, experiment, mesh, own.path.times)
    reference = own if exact is None else Reference(exact, "exact", 0.0)
    check = limits.get("baseline") or (own if exact is not None else None)
    finding.reference, finding.doubt = reference.kind, reference.doubt
    if check is not None:
        finding.cross_check = trajectory_error(check.path, reference.path, experiment.length)
        finding.cross_doubt = check.doubt
    return reference


def _study_tolerances(laboratory: Laboratory, experiment: Experiment, plan: Plan, reference: Path,
                      finding: Finding) -> None:
    mesh = experiment.meshes[experiment.nominal]
    rate = plan.tolerance_rate if experiment.smooth else plan.tolerance_rate_with_impacts
    runs = [Run(experiment, with_tolerance(tolerance), mesh, rate)
            for tolerance in plan.tolerances]
    finding.rows += [_row("time", outcome, reference) for outcome in laboratory.measured(runs)]


def _study_pairs(laboratory: Laboratory, experiment: Experiment, plan: Plan,
                 finding: Finding) -> None:
    """Every step on every mesh, against the exact shape."""
    for mesh in plan.meshes(experiment):
        series = {method.name: _series(laboratory, experiment, method, mesh, list(plan.rates))
                  for method in (kBaseline, kDefault)}
        limit = _limit(series["default"], experiment.smooth, experiment.length)
        if limit is None:
            continue
        exact = _exact(laboratory, experiment, mesh, limit.path.times)
        limit_path = limit.path if exact is None else exact
        shape = experiment.exact_shape(limit_path.times)
        for outcomes in series.values():
            finding.rows += [_row("pairs", outcome, limit_path, limit_path, shape)
                             for outcome in outcomes]


def _study_meshes(laboratory: Laboratory, experiment: Experiment, plan: Plan,
                  finding: Finding) -> None:
    """One step on every mesh, against the finest: the error of the step is the same on all."""
    outcomes = laboratory.measured([Run(experiment, kDefault, mesh, plan.mesh_rate)
                                    for mesh in plan.meshes(experiment)], timed=False)
    finest = outcomes[-1].path
    if finest is None:
        return
    finding.rows += [_row("mesh", outcome, None, outcome.path, finest)
                     for outcome in outcomes[:-1]]


def _row(kind: str, outcome: Outcome, limit: Path | None, of_mesh: Path | None = None,
         shape: Path | None = None) -> Row:
    """`limit`: of small steps; `of_mesh`: the motion by which the mesh is judged against `shape`.
    """
    run, length = outcome.run, outcome.run.experiment.length

    def error(path: Path | None, reference: Path | None) -> float | None:
        known = path is not None and reference is not None and path is not reference
        return trajectory_error(path, reference, length) if known else None
    return Row(run.experiment.name, kind, run.method.name, run.tolerance, run.rate,
               run.mesh.triangles, outcome.steps, outcome.path is None,
               error(outcome.path, limit), error(of_mesh, shape),
               error(outcome.path, shape) if kind == "pairs" else None,
               None if kind == "mesh" else outcome.seconds)
