"""Bodies that drift before the wind."""

import numpy as np

from case import Case, Curve, Plot, Result, compare
from plimsoll import Plimsoll

kScene = "validation/wind_drift.yaml"
kAir, kWater, kSpeed, kHeight = 1.225, 1000, 20, 10
kFreeboard = kDraught = 0.5


def wind_over_water(drift: float, alpha: float, current: float) -> float:
    """Force of the air less that of the water, per ½ C_p and breadth, of a box that drifts at a
    speed: the integral of (U(z) − v)² over the freeboard, and (v − current)² over the draught."""
    top = kSpeed * (kFreeboard / kHeight) ** alpha
    air = kFreeboard * (top ** 2 / (1 + 2 * alpha) - 2 * top * drift / (1 + alpha) + drift ** 2)
    return kAir * air - kWater * kDraught * (drift - current) ** 2


def steady_drift(alpha: float, current: float) -> float:
    """By bisection: the force falls as the drift grows."""
    low, high = current, 0.3 * kSpeed
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if wind_over_water(middle, alpha, current) > 0 else (low, middle)
    return low


def measure(plimsoll: Plimsoll) -> Result:
    result = Result()
    curves = []
    # The profile is within 0.15 % of its speed between heights a factor √2 apart at α = 0.11, and
    # 0.24 % at 0.2; the drift is nearly proportional to the wind.
    for alpha, current, name, tolerance in (
            (0, 0, "uniform wind", 1e-9), (0, 0.5, "uniform wind, current along it", 1e-9),
            (0.11, 0, "power law, exponent 0.11", 1.5e-3),
            (0.2, 0, "power law, exponent 0.2", 2.4e-3)):
        track = plimsoll.run_one(kScene, f"drift_{alpha}_{current}", {
            "air.wind.exponent": alpha, "water.current": [current, 0, 0]})
        exact = steady_drift(alpha, current)
        result.rows.append(compare(f"drift, {name}", "m/s", exact, track.velocity[-1, 0], tolerance,
                                   headline=alpha == 0.11 or name == "uniform wind",
                                   kind="exact" if alpha == 0 else "profile"))
        curves.append(Curve(name, track.t, track.velocity[:, 0]))
    ball = {"bodies[0]": {"name": "box", "density": 500,
                          "icosphere": {"radius": 1, "subdivisions": 3}}, "air.wind.exponent": 0}
    afloat = plimsoll.probe_one(kScene, ball)
    above = plimsoll.probe_one(kScene, {**ball, "bodies[0].position": [0, 0, 5]})
    result.rows.append(compare("force on half a sphere, over half that on a whole one", "N",
                               above.wind.force[0] / 2, afloat.wind.force[0], 1e-12))
    result.plots.append(Plot("A half-immersed box in a wind of 20 m/s", "time [s]", "speed [m/s]",
                             curves))
    return result


kCases = [
    Case("wind_drift", "Sea and frames", "A box drifts before the wind",
         "A box that floats half immersed is pushed by a wind of 20 m/s, uniform or by the power "
         "law, with and without a current.",
         "The speed at which ½ρC_p ∫(U − v)² over the dry half of the box and over its wet half "
         "are equal; C_p is that of front and back together. The profile is linear between "
         "the heights of a table, and right in the mean.",
         [kScene, f"{kScene} --set air.wind.exponent=0"], measure),
]
