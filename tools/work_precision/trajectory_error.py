"""How far a trajectory is from another one, and the limit that ever smaller steps tend to."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rotations import conjugate, from_rotation_vector, product, rotation_vector


@dataclass(frozen=True)
class Path:
    """Poses of B bodies at T times after the start, which all have in common."""

    times: np.ndarray  # T [s]
    position: np.ndarray  # B × T × 3, of the centres of mass [m].
    attitude: np.ndarray  # B × T × 4, quaternions.


def trajectory_error(path: Path, reference: Path, length: float) -> float:
    """Root mean square over bodies and times of the error of the pose,

        e² = |x − x_ref|²/L² + θ²,

    L the scene's length [m], θ the angle from one attitude to the other [rad]."""
    if path.times.shape != reference.times.shape or np.any(
            np.abs(path.times - reference.times) > 1e-9):
        raise ValueError("the two trajectories are not of the same times")
    offset = np.linalg.norm(path.position - reference.position, axis=-1) / length
    angle = np.linalg.norm(
        rotation_vector(product(path.attitude, conjugate(reference.attitude))), axis=-1)
    return float(np.sqrt(np.mean(offset**2 + angle**2)))


def extrapolated(coarse: Path, fine: Path, order: int) -> Path:
    """Richardson's limit of two paths, the fine one of half the step: without the error's leading
    term. Attitudes go on by the same part of the turn between the two."""
    part = 1 / (2**order - 1)
    turn = rotation_vector(product(fine.attitude, conjugate(coarse.attitude)))
    return Path(fine.times, fine.position + part * (fine.position - coarse.position),
                product(from_rotation_vector(part * turn), fine.attitude))


@dataclass(frozen=True)
class Reference:
    path: Path
    kind: str  # What it is, in words.
    doubt: float  # Its own estimated error, as trajectory_error counts.


def limit_of_steps(paths: list[Path], order: int | None, length: float, kind: str) -> Reference:
    """From three paths, each of half the step before.

    With an order, the limit of the last two, in doubt by its distance to the limit of the first
    two. Without, where impacts leave no series in the step, the last path itself, in doubt by its
    distance to the one before."""
    if order is None:
        return Reference(paths[2], kind, trajectory_error(paths[1], paths[2], length))
    limit = extrapolated(paths[1], paths[2], order)
    return Reference(limit, kind,
                     trajectory_error(extrapolated(paths[0], paths[1], order), limit, length))
