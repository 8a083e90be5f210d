"""Where a floating body comes to rest."""

import itertools

import numpy as np

from case import Case, Curve, Plot, Result, Row
from closed_forms import cube_corner_shift
from convergence import kSafety
from plimsoll import Plimsoll, Track, body_axis

kScene = "validation/corner_up.yaml"
kDiagonals = np.array(list(itertools.product((-1, 1), repeat=3))) / np.sqrt(3)
kDuration, kWindow = 600.0, 60.0  # Of a run; of an average [s].
kHalves = (120.0, 360.0, 600.0)  # Where the fading is measured: ends of two intervals [s].
# At the same energy E quadratic drag takes (8/3 pi) sqrt(E) from a swing in a plane and 1/sqrt(2)
# of sqrt(2 E) from one in a circle: 0.849 to 0.707. The swing may change from one to the other.
kShapes = 0.2


def starts() -> dict[str, dict]:
    """Orientations by name: almost flat, almost edge up, and five at random."""
    random = np.random.default_rng(1)
    found = {"one degree from flat": {"axis": [1, 0.3, 0.1], "angle_deg": 1},
             "one degree from edge up": {"euler_deg": [45, 1, 0]}}
    for i in range(5):
        quaternion = random.normal(size=4)
        found[f"random {i + 1}"] = {"quaternion": list(quaternion / np.linalg.norm(quaternion))}
    return found


def vertical_in_body(track: Track) -> np.ndarray:
    """The upward unit vector in body axes, one row a time."""
    return body_axis(track.quaternion * [1, -1, -1, -1], np.array([0.0, 0.0, 1.0]))


def diagonal_angle(up: np.ndarray) -> np.ndarray:
    """Least angle between a body diagonal and directions in body axes [rad]; exact when small."""
    nearest = kDiagonals[np.argmax(up @ kDiagonals.T, axis=1)]
    return np.arcsin(np.minimum(np.linalg.norm(np.cross(up, nearest), axis=1), 1))


def rest_rows(track: Track, start: str, headline: bool) -> list[Row]:
    """The mean attitude of the last window, and how the amplitude fades."""
    up = vertical_in_body(track)
    angle = diagonal_angle(up)
    last = track.t > kDuration - kWindow
    mean = np.average(up[last], axis=0, weights=np.hanning(np.count_nonzero(last)))
    offset = diagonal_angle(mean[None] / np.linalg.norm(mean))[0]
    square = np.average(angle[last]**2, weights=np.hanning(np.count_nonzero(last)))
    return [Row(f"mean angle of the diagonal in the last minute, {start}", "rad", 0, offset, offset,
                float(kSafety * cube_corner_shift() * square), headline=headline,
                kind="asymptotic"),
            Row(f"growth of 1/A from {kHalves[1]:.0f} s on over that before, {start}", "–", 1,
                ratio := fading_ratio(track.t, angle), abs(ratio - 1), kShapes,
                kind="asymptotic")]


def fading_ratio(t: np.ndarray, angle: np.ndarray) -> float:
    """Of the slopes of 1/A, A the root mean square of the angle, in the two intervals."""
    slopes = []
    for first, last in zip(kHalves, kHalves[1:]):
        edges = np.linspace(first, last, 7)
        inverse = [1 / np.sqrt(np.mean(angle[(t >= a) & (t < b)]**2))
                   for a, b in zip(edges, edges[1:])]
        slopes.append(np.polyfit((edges[1:] + edges[:-1]) / 2, inverse, 1)[0])
    return float(slopes[1] / slopes[0])


def envelope(name: str, track: Track) -> Curve:
    """Largest angles [deg] in windows that grow with time, each longer than a swing of 6 s."""
    angle = np.degrees(diagonal_angle(vertical_in_body(track)))
    edges = np.geomspace(10, kDuration, 9)
    return Curve(name, np.sqrt(edges[1:] * edges[:-1]), [
        angle[(track.t >= a) & (track.t < b)].max() for a, b in zip(edges, edges[1:])])


def measure(plimsoll: Plimsoll) -> Result:
    result = Result()
    curves = []
    for i, (start, orientation) in enumerate(starts().items()):
        overrides = {"bodies[0].orientation": orientation}
        afloat = plimsoll.run_one(kScene, f"equilibrium_{i}", {
            **overrides, "bodies[0].start": "equilibrium", "duration": 0.1})
        angle = diagonal_angle(vertical_in_body(afloat))[0]
        result.rows.append(Row(f"angle of the diagonal, start: equilibrium, {start}", "rad", 0,
                               angle, angle, 1e-9, headline=i == 0))
        track = plimsoll.run_one(kScene, f"start_{i}", {
            **overrides, "duration": kDuration, "log.every": 0.1})
        result.rows += rest_rows(track, start, i == 0)
        curves.append(envelope(start, track))
    result.plots.append(Plot("Largest angle of the diagonal", "time [s]", "angle [°]", [
        *curves, Curve("∝ 1/t", [30, kDuration], [10, 300 / kDuration], "k--")], log_x=True,
        log_y=True))
    return result


kCases = [
    Case("corner_up", "Hydrostatics", "A cube of half the water's density rests corner up",
         "From seven orientations with the default drag, for ten minutes. Drag fades with the "
         "square of the speed, so the amplitude A of the last oscillation obeys dA/dt = −kA²: 1/A "
         "grows evenly, but for k, which is up to 20 % less for a swing in a circle than for one "
         "in a plane. The mean attitude is nearer: the restoring moment has a quadratic term that "
         "shifts it by no more than (9/√8) times the mean square of the angle, which gives its "
         "tolerance. With <code>start: equilibrium</code> the cube is put there at once.",
         "Of all orientations of a cube of relative density 0.5 the one with "
         "a diagonal upright has the least potential energy; the others are "
         "saddles or maxima (E. N. Gilbert, How things float, Am. Math. "
         "Monthly 98 (1991) 201–216).", [kScene], measure),
]
