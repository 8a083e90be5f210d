"""The steady part of a response to a regular wave."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

kHarmonics = 3  # Of the wave's frequency; nonlinear loads excite the second and third.
kPadding = 8  # Of the record with zeros, before the spectrum in which free oscillations are sought.
kOwn = 2  # Free oscillations that are told apart.
kWindow = 8  # Wave periods that each of the windows has at least.
kGolden = (np.sqrt(5) - 1) / 2


@dataclass(frozen=True)
class Response:
    """First harmonic of a motion, x = mean + Re(amplitude e^{iθ}) + …, where θ is the phase of the
    wave at the body's mean place: its phase leads the crest there."""

    amplitude: complex  # Unit of the motion.
    change: float  # Of the amplitude from one third to the next, over the amplitude.
    residual: float  # Root mean square of what the fit leaves, over the amplitude.
    mean: float  # Over the last third; unit of the motion.
    drift: float  # Mean velocity over the last third.


def _columns(t: np.ndarray, theta: np.ndarray, own: tuple[float, ...]) -> np.ndarray:
    columns = [np.ones_like(t), t - t.mean()]
    for n in range(1, kHarmonics + 1):
        columns += [np.cos(n * theta), -np.sin(n * theta)]
    for w in own:
        columns += [np.cos(w * t), -np.sin(w * t)]
    return np.stack(columns, axis=1)


def _fit(t: np.ndarray, x: np.ndarray, theta: np.ndarray, own: tuple[float, ...]):
    columns = _columns(t, theta, own)
    parts, *_ = np.linalg.lstsq(columns, x, rcond=None)
    return parts, np.sqrt(np.mean((x - columns @ parts)**2))


def _own_frequency(t: np.ndarray, x: np.ndarray, theta: np.ndarray, omega: float,
                   known: tuple[float, ...]) -> float:
    """The frequency, apart from the wave's harmonics, that lessens the residual most."""
    apart = 2 * np.pi / (t[-1] - t[0])  # Nearer ones are one.
    columns = _columns(t, theta, known)
    rest = x - columns @ np.linalg.lstsq(columns, x, rcond=None)[0]
    size = kPadding * len(t)
    spectrum = np.abs(np.fft.rfft(rest * np.hanning(len(t)), size))
    frequencies = 2 * np.pi * np.fft.rfftfreq(size, (t[-1] - t[0]) / (len(t) - 1))
    taken = (0, *known, *(n * omega for n in range(1, kHarmonics + 1)))
    free = np.all([np.abs(frequencies - w) > apart for w in taken], axis=0)
    best = frequencies[np.argmax(np.where(free, spectrum, 0))]
    low, high = best - apart / 2, best + apart / 2
    left = lambda w: _fit(t, x, theta, (*known, w))[1]
    for _ in range(20):  # Golden-section search.
        inner, outer = high - kGolden * (high - low), low + kGolden * (high - low)
        low, high = (low, outer) if left(inner) < left(outer) else (inner, high)
    return (low + high) / 2


def _phase(t: np.ndarray, omega: float, advance: np.ndarray) -> np.ndarray:
    """Of the wave at the mean path of the body, a straight line over the window."""
    parts, _ = _fit(t, advance, omega * t, ())
    return omega * t - parts[0] - parts[1] * (t - t.mean())


def response(t: np.ndarray, x: np.ndarray, omega: float,
             advance: np.ndarray | None = None) -> Response:
    """Fits mean, drift, harmonics of the wave and free oscillations to the last two thirds of a
    motion, each by itself. Free oscillations of a body that little damps last long.

    t: evenly spaced [s].
    omega: of the wave at a fixed place [rad/s], with a crest over the origin at time 0.
    advance: k·(x, y), by which the wave's phase lags at the body's place [rad]; 0 if left out.
    """
    advance = np.zeros_like(t) if advance is None else advance
    thirds = t[0] + (t[-1] - t[0]) * np.array([1, 2]) / 3
    last, before = t > thirds[1], (t > thirds[0]) & (t <= thirds[1])
    theta = _phase(t[last], omega, advance[last])
    own: tuple[float, ...] = ()
    for _ in range(kOwn):
        own += (_own_frequency(t[last], x[last], theta, omega, own),)
    parts, residual = _fit(t[last], x[last], theta, own)
    previous, _ = _fit(t[before], x[before], _phase(t[before], omega, advance[before]), own)
    amplitude, earlier = complex(*parts[2:4]), complex(*previous[2:4])
    size = max(abs(amplitude), 1e-300)
    return Response(amplitude, abs(amplitude - earlier) / size, residual / size, parts[0], parts[1])
