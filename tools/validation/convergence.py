"""Rows for quantities that converge: three values of a size that halves twice."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from case import Row, compare, compare_all

kSafety = 1.25  # Of an estimated error: what the next term of its series may add.
kMeshOrder = 2
kStepOrder = 2  # At least, of the time stepping: engine/step/stepper.h.
kOrderTolerance = {"mesh": 0.05, "step": 0.1}


def observed_order(values: Sequence[float]) -> float:
    """From the differences of three values, without a reference."""
    a, b, c = values
    return float(np.log2(abs((b - a) / (c - b))))


def whole_order(values: Sequence[float]) -> int:
    """The leading term's power in the size, as far as three values tell it."""
    return int(np.clip(np.round(observed_order(values)), 1, 4))


def extrapolated(values, order: int):
    """Richardson: the limit without the leading error, and how far it is from the limit that the
    first two values give, which is more than its error. Values may be arrays."""
    a, b, c = values
    gain = 2**order - 1
    coarse, fine = b + (b - a) / gain, c + (c - b) / gain
    return fine, np.abs(fine - coarse)


def mesh_rows(quantity: str, unit: str, reference: float, values: Sequence[float], finest: str, *,
              headline: bool = False) -> list[Row]:
    """The finest mesh, the order, and the extrapolated value."""
    expected = kSafety * abs(values[2] - values[1]) / (2**kMeshOrder - 1)
    limit, doubt = extrapolated(values, kMeshOrder)
    return [compare(f"{quantity}, {finest}", unit, reference, values[2],
                    float(expected / abs(reference)), headline=headline, kind="mesh"),
            compare(f"order of the error, {quantity}", "–", kMeshOrder,
                    order_against(reference, values), kOrderTolerance["mesh"], scale=1,
                    kind="mesh"),
            compare(f"{quantity}, three meshes extrapolated", unit, reference, limit,
                    float(doubt / abs(reference)), kind="mesh")]


def order_against(reference: float, values: Sequence[float]) -> float:
    """Between the last two of values whose limit is known."""
    errors = np.abs(np.asarray(values) - reference)
    return float(np.log2(errors[-2] / errors[-1]))


def step_order_rows(quantity: str, values: Sequence[float], floor: float) -> list[Row]:
    """Judges an order by what it lacks. Where the last halving of the step changes less than
    `floor`, relative, no error is left to tell an order from, and there is no row."""
    if abs(values[2] - values[1]) <= floor * abs(values[2]):
        return []
    order = observed_order(values)
    return [Row(f"order of the error with the step, {quantity}, at least", "–", kStepOrder, order,
                max(0.0, kStepOrder - order), kOrderTolerance["step"], kind="step")]


def step_rows(quantity: str, unit: str, reference: float, values: Sequence[float], floor: float, *,
              headline: bool = False) -> list[Row]:
    """The value that three steps extrapolate to, and the order.

    `floor`: error of the measurement that no step takes away, relative."""
    limit, doubt = extrapolated(values, whole_order(values))
    return [compare(f"{quantity}, three steps extrapolated", unit, reference, limit,
                    float(doubt / abs(reference)) + floor, headline=headline, kind="step"),
            *step_order_rows(quantity, values, floor)]


def track_rows(quantity: str, unit: str, reference: np.ndarray, tracks: Sequence[np.ndarray],
               floor: float, *, headline: bool = False) -> list[Row]:
    """The worst of a whole course, extrapolated time by time with the order at the largest change,
    and that order; errors over the reference's range."""
    worst = int(np.argmax(np.abs(tracks[2] - tracks[1])))
    at_worst = [track[worst] for track in tracks]
    limit, doubt = extrapolated(tracks, whole_order(at_worst))
    scale = float(np.ptp(reference))
    return [compare_all(f"{quantity}, worst, three steps extrapolated", unit, reference, limit,
                        float(doubt.max()) / scale + floor, scale=scale, headline=headline,
                        kind="step"),
            *step_order_rows(quantity, at_worst, floor * scale / abs(at_worst[2]))]
