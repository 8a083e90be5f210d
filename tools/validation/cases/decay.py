"""How a floating body's heave, and a flap's swing, decay by the waves that they send out."""

import numpy as np

from case import Case, Curve, Plot, Result, compare
from plimsoll import Plimsoll, Track
from reference_values import value

kScene = "validation/decaying_sphere.yaml"

kReleases = (30, 90, 150)  # Of the model [mm].
kDepth = 0.0348  # Of the model's centre of mass below the sphere's centre [m].
kPeriodGoal, kTroughGoal = 0.006, 0.05

kOesRadius, kOesDepth = 5, 2  # [m]
kOesReleases = (1, 3, 5)  # [m]
kOesGoal = 0.015

kFlapScene = "validation/flap_decay.yaml"
kFlapPeriodGoal, kFlapDampingGoal = 0.03, 0.20


def height(track: Track, depth: float) -> np.ndarray:
    """Of the sphere's centre above the water [m]."""
    return track.position[:, 2] + depth


def first_period(t: np.ndarray, z: np.ndarray) -> float:
    """Twice the time between the first two passages through the rest."""
    at = np.flatnonzero(z[:-1] * z[1:] < 0)[:2]
    first, second = t[at] + (t[at + 1] - t[at]) * z[at] / (z[at] - z[at + 1])
    return 2 * (second - first)


def measure(plimsoll: Plimsoll) -> Result:
    result = Result()
    curves = []
    for release in kReleases:
        track = plimsoll.run_one(kScene, f"model_{release}",
                                 {"bodies[0].position": [0, 0, release / 1000]})
        z = 1000 * height(track, kDepth)
        result.rows += [
            compare(f"first period, released {release} mm high", "s",
                    value(f"decay.period.{release}"), first_period(track.t, z), kPeriodGoal,
                    kind="goal", headline=release == 90),
            compare(f"first trough, released {release} mm high", "mm",
                    -value(f"decay.trough.{release}"), z.min(), kTroughGoal, kind="goal",
                    headline=release == 90)]
        curves.append(Curve(f"{release} mm", track.t, z / release))
    trough = [Curve("" if release > 30 else "experiment, first trough",
                    [value(f"decay.period.{release}") / 2],
                    [-value(f"decay.trough.{release}") / release], "kx")
              for release in kReleases]
    result.plots.append(Plot("A sphere of 0.3 m, let go", "time [s]", "height over the release",
                             curves + trough))
    curves = []
    for release in kOesReleases:
        track = plimsoll.run_one(kScene, f"full_{release}", {
            "gravity": 9.81, "water.density": 1000, "duration": 40, "step": 0.05,
            "bodies[0].icosphere.radius": 5.0009, "bodies[0].mass": 261.8e3,
            "bodies[0].center_of_mass": [0, 0, -kOesDepth],
            "bodies[0].position": [0, 0, release]})
        z = height(track, kOesDepth)
        if release == 1:
            result.rows.append(compare("first trough of a sphere of 10 m, released 1 m high", "m",
                                       value("decay.oes.trough.1"), z.min(), kOesGoal,
                                       kind="goal", headline=True))
        curves.append(Curve(f"{release} m", track.t, z / release))
    result.plots.append(Plot("A sphere of 10 m, let go", "time [s]", "height over the release",
                             curves))
    return result


def peaks(values: np.ndarray) -> np.ndarray:
    """Sizes of the extrema between the first and the last row, by parabolas."""
    before, at, after = values[:-2], values[1:-1], values[2:]
    turns = (at - before) * (after - at) < 0
    slope, bend = (after - before) / 2, before - 2 * at + after
    return np.abs(at - slope**2 / (2 * bend))[turns]


def measure_flap(plimsoll: Plimsoll) -> Result:
    track = plimsoll.run_one(kFlapScene, "flap")
    angle = np.degrees(2 * np.arctan2(track.quaternion[:, 2], track.quaternion[:, 0]))
    at = np.flatnonzero(angle[:-1] * angle[1:] < 0)
    rests = track.t[at] + ((track.t[at + 1] - track.t[at]) * angle[at]
                           / (angle[at] - angle[at + 1]))
    sizes = peaks(angle)
    decrement = np.log(sizes[0] / sizes[-1]) / (len(sizes) - 1)
    period, damping = value("decay.flap.period"), value("decay.flap.decrement")
    result = Result([
        compare("period", "s", period, 2 * np.mean(np.diff(rests)), kFlapPeriodGoal, kind="goal",
                headline=True),
        compare("logarithmic decrement of a half swing", "–", damping, decrement,
                kFlapDampingGoal, kind="goal")])
    t = track.t
    envelope = angle[0] * np.exp(-damping * 2 * t / period)
    result.plots.append(Plot("A bottom-hinged flap, let go", "time [s]", "angle [°]", [
        Curve("ours", t, angle),
        Curve("linear, by WAMIT's coefficients", t, envelope * np.cos(2 * np.pi * t / period),
              "k--")]))
    return result


kCases = [
    Case("wave_decay", "Waves", "Decay of a heaving sphere by the waves that it sends out",
         "A sphere that floats half immersed is let go from 0.2, 0.6 and 1 radius above its rest. "
         "Buoyancy is that of the instantaneous waterline, added mass and memory are those of the "
         "mean pose; there is no drag.",
         "A model of 0.3 m: experiments in a basin (Kramer et al., Energies 14 (2021) 269), whose "
         "period is twice the time between the first two passages through the rest. A sphere of "
         "10 m: the trough of viscous flow in the comparison of the OES task 10 (Wendt et al., J. "
         "Mar. Sci. Eng. 7 (2019) 379), in which programs differ by 3 %. The tolerances are goals: "
         "0.6 % of the period, 5 % and 1.5 % of the trough.", [kScene], measure),
    Case("flap_decay", "Waves", "Decay of a bottom-hinged flap",
         "A flap of 18 by 1.8 m and 127 t on a hinge 8.9 m below the surface of water of 10.9 m is "
         "let go at 5°. A box that ends 0.8 m above the bottom stands for the flap and the base "
         "below it.",
         "WEC-Sim's example OSWEC: the linear decay by the added mass and damping of flap and base "
         "that WAMIT has found for it, and the hydrostatics of its mesh. The base is left out "
         "here. The tolerances are goals: 3 % of the period and 20 % of the damping.", [kFlapScene],
         measure_flap),
]
