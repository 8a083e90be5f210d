"""How small bodies move with the water of waves, and how exactly the motion is stepped."""

import csv
import sys
from pathlib import Path

import numpy as np

from case import Case, Curve, Plot, Result, Row, compare
from closed_forms import DeepWave
from plimsoll import Plimsoll

sys.path.append(str(Path(__file__).resolve().parents[2] / "seakeeping"))

from harmonics import response  # noqa: E402

kSection = "Waves"
kRider = "validation/water_rider.yaml"
kFloat = "float_in_waves.yaml"

kNumber, kSmall = 2 * np.pi / 10, 2e-5  # Of the rider's waves [1/m], [m].
kDepths = (0.75, 1.5, 3)
kRiderSteps = 200
# The sphere feels ∂u/∂t and not Du/Dt, by which it misses 2π² k a = 2.5e-4 of its way in a period;
# its faces and its added mass have 1e-4 each.
kRiderTolerance = 1e-3


def measure_rider(plimsoll: Plimsoll) -> Result:
    result, curves, dots = Result(), [], []
    wave = DeepWave(kSmall, kNumber)
    period = 2 * np.pi / wave.omega
    for depth in kDepths:
        start = wave.velocity((0, -depth), 0)
        track = plimsoll.run_one(kRider, f"depth_{depth}", {
            "water.surface.waves[0].amplitude": kSmall, "bodies[0].position": [0, 0, -depth],
            "bodies[0].linear_velocity": [float(start[0]), 0, float(start[1])],
            "duration": period, "step": period / kRiderSteps, "log.every": period / kRiderSteps})
        drop = wave.path((0, -depth), track.t)
        ours = track.position[:, [0, 2]]
        orbit = np.max(np.linalg.norm(drop - drop[0], axis=1))
        off = np.max(np.linalg.norm(ours - drop, axis=1))
        result.rows.append(compare(f"farthest from the drop in its place, {depth:g} m deep, over "
                                   "the orbit", "–", 0, off / orbit, kRiderTolerance, scale=1,
                                   headline=depth == 1.5, kind="goal"))
        place = np.array([0, -depth]) + (drop - (0, -depth)) / kSmall * 0.3
        curves.append(Curve("" if curves else "water", *place.T, "k-"))
        mine = np.array([0, -depth]) + (ours - (0, -depth)) / kSmall * 0.3
        dots.append(Curve(f"sphere, {depth:g} m deep", *mine[::10].T, "o"))
    result.plots.append(Plot("Orbits of neutrally buoyant spheres as if a were 0.3 m", "x [m]",
                             "z [m]", curves + dots))
    return result


kFactorTwo = 1.0  # Of a ratio whose right value is 1.
kFloatAmplitudes = (0.05, 0.1, 0.2)
kFloatLength = 12  # Of the waves [m].
kFloatCycles, kFloatSteps, kFloatStates = 60, 200, 40
kFloatGoal = 0.1
kRamp = 24  # Of the waves under a float that starts at rest [periods].


def float_in(plimsoll: Plimsoll, wave: DeepWave, radius: float, drag: float, from_rest: bool):
    """Harmonics of surge and heave of a float that starts at rest in waves that grow, or with the
    water on a crest.
    """
    period = 2 * np.pi / wave.omega
    crest = 0 if from_rest else wave.amplitude
    track = plimsoll.run_one(kFloat, f"float_{wave.amplitude}_{radius}_{drag}", {
        "water.surface": {
            "waves": [{"amplitude": wave.amplitude, "wavelength": kFloatLength}],
            "ramp": kRamp * period if from_rest else 0},
        "water.density": 1000, "bodies": [{
            "name": "float", "icosphere": {"radius": radius, "subdivisions": 3}, "density": 500,
            "position": [0, 0, crest], "linear_velocity": [crest * float(wave.omega), 0, 0]}],
        "hydro": {"pressure_drag": drag, "lift": False, "viscous_drag": False},
        "duration": kFloatCycles * period, "step": period / kFloatSteps,
        "log.every": period / kFloatStates})
    advance = wave.number * track.position[:, 0]
    return track, *(response(track.t, track.position[:, axis], wave.omega, advance)
                    for axis in (0, 2))


def measure_float(plimsoll: Plimsoll) -> Result:
    result, drifts, number = Result(), {0.05: [], 0.2: []}, 2 * np.pi / kFloatLength
    for amplitude in kFloatAmplitudes:
        wave = DeepWave(amplitude, number)
        name = f"ka = {number * amplitude:.3f}"
        for radius, drag in ((0.05, 300), (0.2, 0.6)):
            track, surge, heave = float_in(plimsoll, wave, radius, drag, radius == 0.2)
            drifts[radius].append(surge.drift)
            if radius == 0.2:
                result.rows += [
                    compare(f"{motion} of a sphere of 0.2 m over a, {name}", "–", 1,
                            abs(one.amplitude) / amplitude, kFloatGoal, kind="goal",
                            headline=amplitude == 0.1)
                    for motion, one in (("surge", surge), ("heave", heave))]
                # The larger of it and Stokes' drift over the smaller.
                share = surge.drift / (2 * wave.drift_at_surface())
                result.rows.append(compare(
                    f"drift of a sphere of 0.2 m, factor to Stokes' drift, {name}", "–", 1,
                    max(share, 1 / share) if share > 0 else np.inf, kFactorTwo, kind="goal"))
            else:
                result.rows.append(compare(
                    f"drift of a float of {radius:g} m, {name}", "m/s", wave.drift_at_surface(),
                    surge.drift, kFloatGoal, kind="goal", headline=amplitude == 0.1))
        if amplitude == 0.2:
            late = track.t > track.t[-1] - 8 * 2 * np.pi / wave.omega
            result.plots.append(Plot("Path of a float of 0.2 m, ka = 0.105", "x [m]", "z [m]", [
                Curve("", *track.position[late][:, [0, 2]].T, "-")]))
    slope = np.linspace(0, 0.11, 50)
    theory = [DeepWave(e / number, number).drift_at_surface() for e in slope]
    result.plots.append(Plot("Drift of small floats", "ka", "drift [m/s]", [
        Curve("model's water on the surface", slope, theory, "k-"),
        Curve("Stokes' drift", slope, 2 * np.array(theory), "k--"),
        *(Curve(f"float of {radius:g} m", np.array(kFloatAmplitudes) * number, found, style)
          for (radius, found), style in zip(drifts.items(), "os"))]))
    return result


kSteps = (0.02, 0.01, 0.005)
kEnd = 6.0  # [s]
kBudgetTolerance = 1e-4  # At the longest step; it falls with the square of the step.


def budget_error(folder: Path) -> float:
    """What the kinetic energy lacks of the sum of the works, over the works of the water."""
    with open(folder / "forces.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    works = {key: float(rows[-1][key]) for key in rows[-1] if key.startswith("work_")}
    change = float(rows[-1]["kinetic_energy"]) - float(rows[0]["kinetic_energy"])
    return abs(change - sum(works.values())) / sum(
        abs(works[f"work_{load}"]) for load in ("buoyancy", "diffraction", "radiation"))


def measure_steps(plimsoll: Plimsoll) -> Result:
    result, tracks, budgets = Result(), [], []
    for step in (*kSteps, kSteps[-1] / 8):
        name = f"step_{step}"
        track = plimsoll.run_one("validation/sphere_in_waves.yaml", name, {
            "water.surface.waves[0]": {"amplitude": 0.3, "wavelength": 8, "heading_deg": 25},
            "hydro": {"pressure_drag": 0.6, "lift": 0.01, "viscous_drag": 0.01},
            "bodies[0].icosphere.subdivisions": 3, "bodies[0].position": [0, 0, 0.2],
            "duration": kEnd, "step": step,
            "log": {"every": kEnd / 30, "forces": True}})
        tracks.append(track.position)
        budgets.append(budget_error(plimsoll.work / name))
    errors = [float(np.linalg.norm(track - tracks[-1], axis=1).max()) for track in tracks[:-1]]
    result.rows += [
        compare(f"what the budget of works lacks, step {kSteps[0]:g} s", "–", 0, budgets[0],
                kBudgetTolerance, scale=1, headline=True, kind="step"),
        *(Row(f"order of the {what}, at least", "–", 2, order, max(0.0, 2 - order), 0.1, kind="step")
          for what, order in (("largest error of the place", float(np.log2(errors[1] / errors[2]))),
                              ("budget's error", float(np.log2(budgets[1] / budgets[2])))))]
    line = np.array(kSteps)
    result.plots.append(Plot("A floating sphere in waves: error against step", "step [s]",
                             "error", [
        Curve("place [m]", kSteps, errors, "o"), Curve("budget of works", kSteps, budgets[:3], "s"),
        Curve("second order", line, errors[0] * (line / line[0])**2, "k--"),
        Curve("", line, budgets[0] * (line / line[0])**2, "k--")], log_x=True, log_y=True))
    return result


kCases = [
    Case("water_rider", kSection, "A neutrally buoyant sphere follows the water",
         "Spheres of 0.5 m radius, as heavy as the water, start with the water's velocity at "
         "three depths in waves of 10 m and of small height; compared over a period.",
         "The path of a drop that starts at the centre, by Runge–Kutta steps in the model's own "
         "field: pressure and added mass give 1.5 ρV u̇ to 1.5 times the mass.", [kRider],
         measure_rider),
    Case("small_float", kSection, "A small float orbits and drifts with the surface",
         "Spheres of half the water's density on waves of 12 m, three heights; the last third of 60 "
         "periods. The small one starts with the water on a crest and has so much drag that it can "
         "only go with the water. That of 0.2 m has inertia and waves of its own; it starts at rest "
         "in waves that grow, since it would long keep the push of waves that begin at once.",
         "In long waves a float moves as the surface does: its orbit has the wave's amplitude. "
         "What stays on the surface and goes with the water there, ẋ = aω cos(kx − ωt), drifts by "
         "c (1 − (1 − (ka)²)<sup>½</sup>). That is half of Stokes' drift: depth is counted from "
         "the surface, so that what only rides on it has no stronger current on the crest. A sphere "
         "with inertia and waves of its own is held against Stokes' drift within a factor of two.",
         [kFloat],
         measure_float),
    Case("steps_in_waves", kSection, "Order of the step and budget of works in waves",
         "A floating sphere with all loads in steep waves of 8 m, for 6 s; the budget is the "
         "kinetic energy less the sum of the works of all loads.",
         "Against the same with an eighth of the shortest step. Both errors go with the square "
         "of the step.", ["validation/sphere_in_waves.yaml"], measure_steps),
]
