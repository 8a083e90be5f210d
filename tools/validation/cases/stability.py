"""Where a floating body comes to rest."""

import itertools

import numpy as np

from case import Case, Curve, Plot, Result, compare
from plimsoll import Plimsoll, Track, body_axis

kScene = "validation/corner_up.yaml"
kStarts = 6


def diagonal_angle(track: Track) -> np.ndarray:
    """Least angle between a body diagonal and the vertical [deg]."""
    diagonals = [np.array([x, y, 1.0]) / np.sqrt(3)
                 for x, y in itertools.product((-1, 1), repeat=2)]
    cosines = np.max([np.abs(body_axis(track.quaternion, d)[:, 2]) for d in diagonals], axis=0)
    return np.degrees(np.arccos(np.minimum(cosines, 1)))


def measure(plimsoll: Plimsoll) -> Result:
    random = np.random.default_rng(1)
    result = Result()
    curves = []
    for start in range(kStarts):
        quaternion = random.normal(size=4)
        track = plimsoll.run_one(kScene, f"start_{start}", {
            "bodies[0].orientation": {"quaternion": list(quaternion / np.linalg.norm(quaternion))}})
        angle = diagonal_angle(track)
        result.rows.append(compare(f"angle of the diagonal at the end, start {start + 1}", "°", 0,
                                   angle[-1], 0.5, scale=1, headline=start == 0))
        curves.append(Curve(f"start {start + 1}", track.t, angle))
    result.plots.append(Plot("Nearest body diagonal to the vertical", "time [s]", "angle [°]",
                             curves))
    return result


kCases = [
    Case("corner_up", "Hydrostatics", "A cube of half the water's density rests corner up",
         "From six random orientations, damped by a large pressure drag, for two minutes. Drag "
         "fades with the square of the speed, so the last of the motion dies out slowly, as 1/t: "
         "the tolerance is half a degree.",
         "Of all orientations of a cube of relative density 0.5 the one with "
         "a diagonal upright has the least potential energy; the others are "
         "saddles or maxima (E. N. Gilbert, How things float, Am. Math. "
         "Monthly 98 (1991) 201–216).", [kScene], measure),
]
