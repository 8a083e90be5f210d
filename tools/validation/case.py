"""What a validation case is: a comparison of the program with a reference, by name."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np


kLargestExact = 1e-9  # Tolerance of what is represented exactly.

# Every kind of comparison, and the rule for its tolerance.
kKinds = {
    "exact": "The program is given the very shape that the reference is for: nothing but round-off "
             "may remain, at most 1e-9.",
    "mesh": "Flat panels stand for what is smooth. Measured with three meshes whose panels halve: "
            "the tolerance is 1.25 times the error that the last two let expect, and the order is "
            "2. An extrapolated value is judged by the difference of the two extrapolations. Where "
            "there is one mesh, the case argues the bound.",
    "step": "Steps of time stand for time. As with meshes, with three steps that halve; the order "
            "may be higher than the one that is judged.",
    "profile": "A power-law wind is linear between the heights of a table: the tolerance is the "
               "bound of what a chord of the law leaves.",
    "goal": "The program chooses its own panels, so that meshes cannot be halved: the tolerance is "
            "the accuracy that is asked of the method, set before it was measured.",
    "raster": "The reference itself is counted on a raster of points; the case argues its error.",
    "statistical": "A finite sample stands for a distribution: the tolerance is exceeded once in "
                   "ten thousand times by chance.",
    "asymptotic": "A motion dies out without ever ending: the tolerance follows from the amplitude "
                  "that is left.",
    "shown": "Not judged: it tells how far the model, or the thesis, is from the truth.",
}


@dataclass(frozen=True)
class Row:
    """One compared quantity. The error is a pure number: the difference over `scale`."""

    quantity: str
    unit: str
    reference: float
    ours: float
    error: float
    tolerance: float | None  # None: shown, not judged.
    thesis: float | None = None  # What the thesis found for the same quantity.
    headline: bool = False  # Represents its case in tests/validation/README.md.
    kind: str = "exact"  # One of kKinds.

    def __post_init__(self):
        if self.tolerance is None:
            object.__setattr__(self, "kind", "shown")
        assert self.kind in kKinds, self.kind
        if self.kind == "exact" and self.tolerance > kLargestExact:
            raise ValueError(f"{self.quantity}: {self.tolerance} is no tolerance of an exact row")

    @property
    def passed(self) -> bool:
        """A quantity that is not judged passes; a NaN never does."""
        return self.tolerance is None or bool(self.error <= self.tolerance)


def compare(quantity: str, unit: str, reference: float, ours: float, tolerance: float | None, *,
            scale: float | None = None, thesis: float | None = None,
            headline: bool = False, kind: str = "exact") -> Row:
    """Error relative to the reference, or to `scale` where the reference is zero or small."""
    error = abs(ours - reference) / abs(reference if scale is None else scale)
    return Row(quantity, unit, float(reference), float(ours), float(error), tolerance, thesis,
               headline, kind)


def compare_vectors(quantity: str, unit: str, reference: Sequence[float], ours: Sequence[float],
                    tolerance: float | None, *, scale: float | None = None,
                    headline: bool = False) -> Row:
    """The norms are shown, the error is the norm of the difference over `scale`, by default the
    reference's norm."""
    a, b = np.asarray(reference, float), np.asarray(ours, float)
    norm = float(np.linalg.norm(a))
    error = float(np.linalg.norm(b - a)) / (norm if scale is None else scale)
    return Row(quantity, unit, norm, float(np.linalg.norm(b)), error, tolerance,
               headline=headline)


def compare_all(quantity: str, unit: str, reference: Sequence[float], ours: Sequence[float],
                tolerance: float | None, *, scale: float, **options) -> Row:
    """The worst of many pairs: its values, and its error over `scale`."""
    a, b = np.asarray(reference, float), np.asarray(ours, float)
    worst = int(np.argmax(np.nan_to_num(np.abs(b - a), nan=np.inf)))
    return compare(quantity, unit, a[worst], b[worst], tolerance, scale=scale, **options)


@dataclass(frozen=True)
class Curve:
    label: str  # Empty: not in the legend.
    x: Sequence[float]
    y: Sequence[float]
    style: str = "-"  # As matplotlib writes it.


@dataclass(frozen=True)
class Plot:
    title: str
    x_label: str
    y_label: str
    curves: Sequence[Curve]
    log_x: bool = False
    log_y: bool = False
    log_base: int = 10


@dataclass
class Result:
    rows: list[Row] = field(default_factory=list)
    plots: list[Plot] = field(default_factory=list)

    @property
    def passed(self) -> bool:
        return all(row.passed for row in self.rows)


@dataclass(frozen=True)
class Case:
    """A comparison. `text` and `exact` are HTML: what is compared, and why the reference is right.
    `scenes` are to be run by people: paths below scenes/, with `--set` where a variation is meant.
    """

    name: str
    section: str
    title: str
    text: str
    exact: str
    scenes: Sequence[str]
    measure: Callable[..., Result]
    timed: bool = False  # Judges nothing and measures time: no test.
