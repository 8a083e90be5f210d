"""Cost of a step against the number of triangles (thesis, Fig. 15)."""

import numpy as np

from case import Case, Curve, Plot, Result, Row
from plimsoll import Plimsoll

kScene = "validation/held_sphere.yaml"
kCounts = (16, 32, 64, 96, 128)
kRepeats = 2
kStates = {"submerged": -3.0, "half immersed": 0.0}  # Height of the centre [m].
kStepsTimed = 60


def triangle_count(count: int) -> int:
    """Of a UV sphere with as many slices as stacks."""
    return 2 * count * (count - 1)


def hydro_time(plimsoll: Plimsoll, count: int, height: float) -> float:
    """Of one simulated second at 60 Hz, the least of some runs [s]."""
    times = []
    for repeat in range(kRepeats):
        _, summary = plimsoll.run(kScene, f"cost_{count}_{height:g}_{repeat}", {
            "bodies[0].sphere.slices": count, "bodies[0].sphere.stacks": count,
            "bodies[0].position": [0, 0, height]})
        times.append(summary["wall_seconds"]["hydro"])
    return min(times)


def measure(plimsoll: Plimsoll) -> Result:
    triangles = np.array([triangle_count(n) for n in kCounts])
    result = Result()
    curves = []
    for (name, height), style in zip(kStates.items(), ("o-", "s--")):
        times = np.array([hydro_time(plimsoll, n, height) for n in kCounts])
        slope = float(np.polyfit(np.log(triangles[1:]), np.log(times[1:]), 1)[0])
        per_panel = times[-1] / kStepsTimed / triangles[-1] * 1e9
        result.rows += [
            Row(f"exponent of time over triangles, {name}", "–", 1, slope, abs(slope - 1), None),
            Row(f"time a triangle and step, {triangles[-1]} triangles, {name}", "ns", float("nan"),
                per_panel, float("nan"), None)]
        curves.append(Curve(name, triangles, times, style))
    result.plots.append(Plot("Time for the loads of 1 s at 60 Hz", "triangles", "time [s]", curves))
    return result


kCases = [
    Case("cost", "Cost", "Cost of a step against triangles",
         "Thesis, Fig. 15: one second at 60 Hz, a sphere held under water, all loads but added "
         "mass; and the same at the surface. One thread, the lesser of two runs. The sphere "
         "turns, so that no load can be taken over from the step before.",
         "There is no exact answer: the thesis found a linear "
         "dependence, exponent 1. Nothing is judged here.", [kScene], measure, timed=True),
]
