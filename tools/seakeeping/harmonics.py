"""The steady part of a response to a regular wave."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

kHarmonics = 3  # Of the wave's frequency; nonlinear loads excite the second and third.
kOwnFrequencies = 400  # Candidates for the frequency of a free oscillation that has not died out.
kWindow = 6  # Wave periods in each of the two windows that are compared.


@dataclass(frozen=True)
class Response:
    """First harmonic of a motion, x = mean + Re(amplitude e^{iωt}) + …"""

    amplitude: complex  # Unit of the motion; its phase leads a crest at the origin at time 0.
    change: float  # Of the amplitude from one window to the next, over the amplitude.
    residual: float  # Root mean square of what the fit leaves, over the amplitude.


def _columns(t: np.ndarray, omega: float, own: float | None) -> np.ndarray:
    columns = [np.ones_like(t), t - t.mean()]
    for n in range(1, kHarmonics + 1):
        columns += [np.cos(n * omega * t), -np.sin(n * omega * t)]
    if own:
        columns += [np.cos(own * t), -np.sin(own * t)]
    return np.stack(columns, axis=1)


def _fit(t: np.ndarray, x: np.ndarray, omega: float, own: float | None):
    columns = _columns(t, omega, own)
    parts, *_ = np.linalg.lstsq(columns, x, rcond=None)
    return complex(parts[2], parts[3]), np.sqrt(np.mean((x - columns @ parts)**2))


def _own_frequency(t: np.ndarray, x: np.ndarray, omega: float) -> float:
    """The frequency, apart from the wave's harmonics, that lessens the residual most."""
    span = t[-1] - t[0]
    candidates = np.linspace(2 * np.pi / span, 4 * omega, kOwnFrequencies)
    apart = [w for w in candidates
             if min(abs(w - n * omega) for n in range(1, kHarmonics + 1)) > np.pi / span]
    return min(apart, key=lambda w: _fit(t, x, omega, w)[1])


def response(t: np.ndarray, x: np.ndarray, omega: float, damped: bool = True) -> Response:
    """Fits mean, drift and harmonics of the wave to the last two windows of a motion.

    damped: if False, one free oscillation of the body is fitted, too, over the whole of the record.
    """
    window = kWindow * 2 * np.pi / omega
    if damped:
        last, before = t > t[-1] - window, (t > t[-1] - 2 * window) & (t <= t[-1] - window)
        own = None
    else:
        half = (t[0] + t[-1]) / 2
        last, before = t > half, t <= half
        own = _own_frequency(t, x, omega)
    amplitude, residual = _fit(t[last], x[last], omega, own)
    previous, _ = _fit(t[before], x[before], omega, own)
    size = max(abs(amplitude), 1e-300)
    return Response(amplitude, abs(amplitude - previous) / size, residual / size)
