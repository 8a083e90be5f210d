"""What the measured errors and times say: orders, and one method against another."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from studies import Finding, Row

kTarget = 1e-3  # The error at which methods are compared.
kOrderRates = (60, 960)  # Between which steps the order is taken.


@dataclass(frozen=True)
class Ratio:
    """A measured ratio, or what it is at least."""

    value: float
    at_least: bool = False

    def __str__(self) -> str:
        rounded = float(f"{self.value:.2g}")
        return ("> " if self.at_least else "") + format(rounded, ",.0f" if rounded >= 10 else "g")


@dataclass(frozen=True)
class Judgement:
    """Of one method against the plain one, on one experiment; None: the runs do not tell."""

    experiment: str
    smooth: bool
    method: str
    order: float | None  # Of the error of time with the step.
    target: float | None  # The error at which both are compared.
    baseline_seconds: float | None  # In which the plain method reaches it.
    error_ratio: Ratio | None  # The plain method's error over this one's at that time.
    speed_ratio: Ratio | None  # The plain method's time over this one's at equal error.


@dataclass(frozen=True)
class Curve:
    """Error against run time: cheapest first, the error being the largest from there on, so that
    a lucky run does not count."""

    seconds: np.ndarray
    error: np.ndarray

    def time_of(self, target: float) -> tuple[float, bool] | None:
        """Run time from which the error stays at `target` or less; and whether that is known only
        as an upper bound, since the cheapest run is better already. None: never."""
        below = self.error <= target
        if not below.any():
            return None
        first = int(np.argmax(below))
        if first == 0:
            return float(self.seconds[0]), True
        return _between(target, self.error[first - 1:first + 1],
                        self.seconds[first - 1:first + 1]), False

    def error_at(self, seconds: float) -> tuple[float, bool] | None:
        """Error that is reached in this time; and whether that is known only as an upper bound,
        since there is no run as dear. None: the cheapest run takes longer."""
        if seconds < self.seconds[0]:
            return None
        if seconds >= self.seconds[-1]:
            return float(self.error[-1]), bool(seconds > self.seconds[-1])
        after = int(np.searchsorted(self.seconds, seconds, side="right"))
        return _between(seconds, self.seconds[after - 1:after + 1],
                        self.error[after - 1:after + 1]), False


def _between(x: float, xs: np.ndarray, ys: np.ndarray) -> float:
    """On a straight line in logarithms."""
    part = np.log(x / xs[0]) / np.log(xs[1] / xs[0])
    return float(ys[0] * (ys[1] / ys[0])**part)


def series_of(finding: Finding, method: str) -> list[Row]:
    """The runs of a method on the nominal mesh whose error is known: those that stayed finite and
    are not the reference themselves."""
    return [row for row in finding.rows
            if row.study == "time" and row.method == method and row.error_time is not None]


def curve_of(finding: Finding, method: str) -> Curve | None:
    """Errors below the finding's floor count as the floor."""
    rows = sorted(series_of(finding, method), key=lambda row: row.seconds)
    if not rows:
        return None
    error = np.maximum([row.error_time for row in rows], finding.floor)
    return Curve(np.array([row.seconds for row in rows]),
                 np.maximum.accumulate(error[::-1])[::-1])


def order_of(finding: Finding, method: str) -> float | None:
    """Slope of the logarithms by least squares, over errors above the floor. None: below three."""
    rows = [row for row in series_of(finding, method) if row.tolerance is None
            and kOrderRates[0] <= row.rate <= kOrderRates[1] and row.error_time > finding.floor]
    if len(rows) < 3:
        return None
    slope = np.polyfit(np.log([row.rate for row in rows]),
                       np.log([row.error_time for row in rows]), 1)[0]
    return float(-slope)


def target_of(finding: Finding) -> tuple[float, float] | None:
    """The error at which methods are compared, and the plain method's run time to it. kTarget, or
    the plain method's best where it gets no further. None: it is better with its largest step."""
    plain = curve_of(finding, "baseline")
    if plain is None:
        return None
    target = max(kTarget, float(plain.error[-1]))
    seconds, bound = plain.time_of(target)
    return None if bound else (target, seconds)


def judge(finding: Finding, method: str) -> Judgement:
    ours, plain = curve_of(finding, method), curve_of(finding, "baseline")
    compared = target_of(finding)
    order = None if method == "tolerance" else order_of(finding, method)
    target, seconds = compared or (None, None)
    both = compared is not None and ours is not None and method != "baseline"
    return Judgement(finding.experiment.name, finding.experiment.smooth, method, order, target,
                     seconds, _error_ratio(ours, target, seconds, finding.floor) if both else None,
                     _speed_ratio(ours, plain, target, seconds) if both else None)


def _error_ratio(ours: Curve, target: float, seconds: float, floor: float) -> Ratio | None:
    reached = ours.error_at(seconds)
    if reached is None:
        return None
    error, bound = reached
    return Ratio(target / error, bound or bool(error <= floor))


def _speed_ratio(ours: Curve, plain: Curve, target: float, seconds: float) -> Ratio | None:
    """At the target; or, where the cheapest run is better already, at that run's error if the plain
    method gets there."""
    reached = ours.time_of(target)
    if reached is None:
        return None
    at_own = plain.time_of(float(ours.error[0])) if reached[1] else None
    if at_own is not None and not at_own[1]:
        return Ratio(at_own[0] / reached[0])
    return Ratio(seconds / reached[0], reached[1])
