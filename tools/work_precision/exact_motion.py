"""Exact motions: closed forms, and ordinary differential equations solved by themselves here, with
another method than the program's, to round-off."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from rotations import from_rotation_vector, product, rotated
from trajectory_error import Path

kPiece = 1 / 1500  # Longest piece of Runge and Kutta's method [s].


def runge_kutta(rate: Callable[[np.ndarray], np.ndarray], start: np.ndarray,
                times: np.ndarray, piece: float = kPiece) -> np.ndarray:
    """States at ascending times after 0, by the classical method of fourth order."""
    states, state, now = [], np.asarray(start, float), 0.0
    for time in times:
        count = int(np.ceil((time - now) / piece - 1e-9))
        h = (time - now) / count
        for _ in range(count):
            k1 = rate(state)
            k2 = rate(state + h / 2 * k1)
            k3 = rate(state + h / 2 * k2)
            k4 = rate(state + h * k3)
            state = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        states.append(state)
        now = time
    return np.array(states)


def upright(times: np.ndarray, z: np.ndarray) -> Path:
    """A body that moves up and down at x = y = 0 and does not turn."""
    position = np.zeros((1, len(times), 3))
    position[0, :, 2] = z
    return Path(times, position, np.broadcast_to([1.0, 0, 0, 0], (1, len(times), 4)))


def heave_of_sphere(times: np.ndarray, radius: float, density_ratio: float, start: float,
                    gravity: float, piece: float = kPiece) -> Path:
    """A sphere let go with its centre `start` above the water, under weight and buoyancy of the
    spherical segment below the water, V = π d² (3R − d)/3 with the draught d = R − z."""
    def rate(state: np.ndarray) -> np.ndarray:
        draught = np.clip(radius - state[0], 0, 2 * radius)
        volume = np.pi * draught**2 * (3 * radius - draught) / 3
        whole = 4 / 3 * np.pi * radius**3
        return np.array([state[1], gravity * (volume / (whole * density_ratio) - 1)])
    return upright(times, runge_kutta(rate, np.array([start, 0.0]), times, piece)[:, 0])


def sinking(times: np.ndarray, start: float, net_weight: float, drag: float, mass: float) -> Path:
    """From rest under a net weight [N] and a drag [N s²/m²] times the speed squared:
    w = w_∞ tanh(t/τ), w_∞² = weight/drag, τ = mass w_∞/weight."""
    terminal = np.sqrt(net_weight / drag)
    tau = mass * terminal / net_weight
    # ln cosh x without its overflow.
    log_cosh = times / tau + np.log1p(np.exp(-2 * times / tau)) - np.log(2)
    return upright(times, start - terminal * tau * log_cosh)


def pendulum(times: np.ndarray, angle: float, length: float, rate_squared: float,
             anchor: np.ndarray, piece: float = kPiece) -> Path:
    """θ'' = −rate² sin θ from rest, θ about +y from hanging; the centre of mass is `length` from
    the anchor, straight below it in body axes."""
    def rate(state: np.ndarray) -> np.ndarray:
        return np.array([state[1], -rate_squared * np.sin(state[0])])
    theta = runge_kutta(rate, np.array([angle, 0.0]), times, piece)[:, 0]
    attitude = from_rotation_vector(np.outer(theta, [0.0, 1.0, 0.0]))
    position = np.asarray(anchor) + rotated(attitude, np.array([0.0, 0.0, -length]))
    return Path(times, position[None], attitude[None])


def torque_free(times: np.ndarray, inertia: np.ndarray, position: np.ndarray, velocity: np.ndarray,
                spin: np.ndarray, piece: float = kPiece) -> Path:
    """Kirchhoff's equations in unbounded fluid (Lamb 1932, §124), in body axes,

        p' = p × ω,   l' = l × ω + p × v,   (p, l) = (M + A)(v, ω),

    from unturned body axes. `inertia` is M + A, 6 × 6, about the centre of mass."""
    inverse = np.linalg.inv(inertia)

    def rate(state: np.ndarray) -> np.ndarray:
        p, l, q = state[0:3], state[3:6], state[9:13]
        twist = inverse @ state[:6]
        v, w = twist[:3], twist[3:]
        half_spin = np.concatenate([[0.0], w / 2])
        return np.concatenate([_cross(p, w), _cross(l, w) + _cross(p, v), rotated(q, v),
                               product(q, half_spin)])
    start = np.concatenate([inertia @ np.concatenate([velocity, spin]), position, [1.0, 0, 0, 0]])
    states = runge_kutta(rate, start, times, piece)
    attitude = states[:, 9:13] / np.linalg.norm(states[:, 9:13], axis=1, keepdims=True)
    return Path(times, states[None, :, 6:9], attitude[None])


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """numpy's cross product of two vectors takes ten times as long."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                     a[0] * b[1] - a[1] * b[0]])
