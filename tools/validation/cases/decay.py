"""How a floating body's heave, a barge's roll and a flap's swing decay."""

from pathlib import Path

import numpy as np

from case import Case, Curve, Plot, Result, compare
from plimsoll import Plimsoll, Track
from reference_values import value

kScene = "validation/decaying_sphere.yaml"

kReleases = (30, 90, 150)  # Of the model [mm].
kDepth = 0.0348  # Of the model's centre of mass below the sphere's centre [m].
kPeriodGoal, kTroughGoal = 0.006, 0.05

kDragTroughGoal = 0.06  # With drag, whose part is the difference from the run without.

kOesRadius, kOesDepth = 5, 2  # [m]
kOesReleases = (1, 3, 5)  # [m]
kOesGoal = 0.015
kOesSeries = Path(__file__).resolve().parents[1] / "sphere_decay.csv"  # Released 1 m high.
kOesSeriesGoal = 0.012  # Root of the mean square of the difference [m].

kRollScene = "validation/rolling_barge.yaml"
kRollPeriodGoal, kRollDampingGoal = 0.03, 0.25
kRollNumericalGoal = 0.03  # Of what half the step, a finer mesh and a longer barge change.

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
    release = kReleases[-1]
    dragged = plimsoll.run_one(kScene, "model_with_drag", {
        "bodies[0].position": [0, 0, release / 1000],
        "hydro": {"pressure_drag": {"front": 0.71, "back": 0.3}, "viscous_drag": "ittc57"}})
    z = 1000 * height(dragged, kDepth)
    result.rows.append(compare(
        f"first trough with the default drag, released {release} mm high", "mm",
        -value(f"decay.trough.{release}"), z.min(), kDragTroughGoal, kind="goal", headline=True))
    curves.append(Curve(f"{release} mm, with drag", dragged.t, z / release, "--"))
    trough = [Curve("" if release > 30 else "experiment, first trough",
                    [value(f"decay.period.{release}") / 2],
                    [-value(f"decay.trough.{release}") / release], "kx")
              for release in kReleases]
    result.plots.append(Plot("A sphere of 0.3 m, let go", "time [s]", "height over the release",
                             curves + trough))
    curves = []
    full = {"gravity": 9.81, "water.density": 1000, "duration": 40, "step": 0.05,
            "bodies[0].icosphere.radius": 5.0009, "bodies[0].mass": 261.8e3,
            "bodies[0].center_of_mass": [0, 0, -kOesDepth]}
    for release in kOesReleases:
        track = plimsoll.run_one(kScene, f"full_{release}",
                                 {**full, "bodies[0].position": [0, 0, release]})
        z = height(track, kOesDepth)
        if release == 1:
            result.rows.append(compare("first trough of a sphere of 10 m, released 1 m high", "m",
                                       value("decay.oes.trough.1"), z.min(), kOesGoal,
                                       kind="goal", headline=True))
        curves.append(Curve(f"{release} m", track.t, z / release))
    track = plimsoll.run_one(kScene, "full_defaults",
                             {**full, "bodies[0].position": [0, 0, 1], "hydro": {}})
    at, reference = np.loadtxt(kOesSeries, delimiter=",", skiprows=1, unpack=True)
    off = np.interp(at, track.t, height(track, kOesDepth)) - reference
    result.rows.append(compare("the same with the default drag, 40 s: root mean square of the "
                               "difference", "m", 0, np.sqrt(np.mean(off**2)), kOesSeriesGoal,
                               scale=1, kind="goal", headline=True))
    curves.append(Curve("viscous flow, 1 m", at, reference, "k."))
    result.plots.append(Plot("A sphere of 10 m, let go", "time [s]", "height over the release",
                             curves))
    return result


def peaks(values: np.ndarray) -> np.ndarray:
    """Sizes of the extrema between the first and the last row, by parabolas."""
    before, at, after = values[:-2], values[1:-1], values[2:]
    turns = (at - before) * (after - at) < 0
    slope, bend = (after - before) / 2, before - 2 * at + after
    return np.abs(at - slope**2 / (2 * bend))[turns]


def roll_decay(plimsoll: Plimsoll, name: str, overrides: dict) -> tuple[float, float, Track]:
    """Period [s], damping ratio over the first of it, and the track of the barge."""
    track = plimsoll.run_one(kRollScene, name, overrides)
    angle = np.degrees(2 * np.arctan2(track.quaternion[:, 1], track.quaternion[:, 0]))
    at = np.flatnonzero(angle[:-1] * angle[1:] < 0)
    rests = track.t[at] + ((track.t[at + 1] - track.t[at]) * angle[at]
                           / (angle[at] - angle[at + 1]))
    ratio = np.log(angle[0] / peaks(angle)[1]) / (2 * np.pi)
    return 2 * float(np.mean(np.diff(rests))), float(ratio), track


def measure_roll(plimsoll: Plimsoll) -> Result:
    period, ratio, track = roll_decay(plimsoll, "roll", {})
    waves = roll_decay(plimsoll, "roll_waves", {"bodies[0].hydro": {
        "radiation": "auto", "pressure_drag": False, "viscous_drag": False}})
    steady = roll_decay(plimsoll, "roll_steady", {"bodies[0].hydro": {
        "radiation": "auto", "pressure_drag": {"front": 0.71, "back": 0.3, "blunt": 0}}})
    result = Result([
        compare("period", "s", value("decay.roll.period"), period, kRollPeriodGoal, kind="goal"),
        compare("damping ratio, let go at 15°", "–", value("decay.roll.damping"), ratio,
                kRollDampingGoal, kind="goal", headline=True),
        compare("the same of its waves alone", "–", value("decay.roll.damping"), waves[1], None),
        compare("the same with steady drag", "–", value("decay.roll.damping"), steady[1], None)])
    for title, change in (("half the step", {"step": 0.005}),
                          ("edges in four", {"bodies[0].box.divisions": 4})):
        finer = roll_decay(plimsoll, title.replace(" ", "_"), change)[1]
        result.rows.append(compare(f"damping ratio with {title}", "–", finer, ratio,
                                   kRollNumericalGoal, kind="goal"))
    t = track.t
    curves = [Curve(title, one.t, np.degrees(2 * np.arctan2(one.quaternion[:, 1],
                                                            one.quaternion[:, 0])), style)
              for title, one, style in (("with drag", track, "-"),
                                        ("waves alone", waves[2], "--"),
                                        ("steady drag", steady[2], ":"))]
    envelope = 15 * np.exp(-value("decay.roll.damping") * 2 * np.pi * t
                           / value("decay.roll.period"))
    result.plots.append(Plot("A barge let go at 15°", "time [s]", "roll [°]", [
        *curves, Curve("experiment, envelope", t, envelope, "k--")]))
    return result


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
         "mean pose. There is no drag but in one run, in which drag takes only what bodies lose "
         "whose wake is not formed.",
         "A model of 0.3 m: experiments in a basin (Kramer et al., Energies 14 (2021) 269), whose "
         "period is twice the time between the first two passages through the rest. A sphere of "
         "10 m: NREL's viscous flow in the comparison of the OES task 10 (Wendt et al., J. Mar. Sci. "
         "Eng. 7 (2019) 379), in which programs differ by 3 % in the trough and by 6 to 33 mm over "
         "40 s (root mean square). The tolerances are goals: "
         "0.6 % of the period, 5 % and 1.5 % of the trough, 12 mm over 40 s, and 6 % with drag.", [kScene],
         measure),
    Case("roll_decay", "Waves", "Decay of a rolling barge by the vortices of its edges",
         "A barge of 0.3 m breadth and 0.05 m draught on a hinge along its axis in the waterline is "
         "let go at 15°. The drag of its panels is too little by far while its wake is not formed; "
         "its edges shed a vortex in every swing.",
         "A model that reaches from wall to wall of a flume (Jung et al., Ocean Engineering 33 "
         "(2006) 1626). Drag of edges is not fitted to it: it is that of Ikeda's formula for sharp "
         "bilges. What half the step and a finer mesh change is the numerical error; the rest is "
         "that of the model. The tolerances are goals: 3 % of the period, 25 % of the damping, 3 % "
         "of numerical error.", [kRollScene], measure_roll),
    Case("flap_decay", "Waves", "Decay of a bottom-hinged flap",
         "A flap of 18 by 1.8 m and 127 t on a hinge 8.9 m below the surface of water of 10.9 m is "
         "let go at 5°. A box that ends 0.8 m above the bottom stands for the flap and the base "
         "below it.",
         "WEC-Sim's example OSWEC: the linear decay by the added mass and damping of flap and base "
         "that WAMIT has found for it, and the hydrostatics of its mesh. The base is left out "
         "here. The tolerances are goals: 3 % of the period and 20 % of the damping.", [kFlapScene],
         measure_flap),
]
