"""Forces of small waves on bodies that are held: pressure, and the water past the added mass."""

import numpy as np

from case import Case, Curve, Plot, Result, compare, compare_all
from closed_forms import DeepWave, hemisphere_froude_krylov, kGravity
from convergence import mesh_rows
from plimsoll import Plimsoll
from reference_values import value

kSection = "Waves"
kDeep = "validation/water_rider.yaml"
kHemisphere = "validation/sphere_in_waves.yaml"
kAmplitude = 1e-5  # Small: linear theory is the reference [m].
# `wave_tolerance` is 0 for that reason: it is relative to the buoyancy, which does not shrink.
# Of the added mass, by its solver; and faces that are flat displace less than a sphere.
kDeepGoal = 2e-3
kFlatFaces = 5e-4  # Twice what 20,480 of them displace less than the ball, 2.4e-4.


def wave_loads(plimsoll: Plimsoll, scene: str, wave: DeepWave, phase_deg: float,
               changes: dict | None = None) -> tuple[np.ndarray, np.ndarray, float]:
    """Force of the waves' pressure alone, that of wave_inertia or diffraction, and the torque's size
    of both; half the difference of the loads of a wave and of its opposite."""
    loads = []
    for phase in (phase_deg, phase_deg + 180):
        train = {"amplitude": wave.amplitude, "wavelength": 2 * np.pi / wave.number,
                 "phase_deg": phase}
        body = plimsoll.probe_one(scene, {"water.surface": {"waves": [train]},
                                          "hydro.wave_tolerance": 0, **(changes or {})})
        loads.append((body.buoyancy, body.wave_inertia, body.diffraction))
    half = lambda i, part: (getattr(loads[0][i], part) - getattr(loads[1][i], part)) / 2
    torque = np.linalg.norm(sum(half(i, "torque") for i in range(3)))
    return half(0, "force"), half(1, "force") + half(2, "force"), float(torque)


def measure_deep(plimsoll: Plimsoll) -> Result:
    result, radius, depth = Result(), 0.5, 1.5
    mass = 1000 * plimsoll.probe_one(kDeep).volume
    numbers, totals, pressures = (0.1, 0.3, 0.5, 1, 2), [], []
    for k_radius in numbers:
        wave = DeepWave(kAmplitude, k_radius / radius)
        pressure, inertia, torque = wave_loads(plimsoll, kDeep, wave, 30)
        # The phase at the origin is 30°: a wave that has come from t = −30°/ω.
        u = wave.acceleration((0, -depth), -np.radians(30) / wave.omega)
        ours, unit = (pressure + inertia)[[0, 2]], mass * np.linalg.norm(u)
        totals.append(np.linalg.norm(ours) / unit)
        pressures.append(np.linalg.norm(pressure) / unit)
        result.rows += [
            compare_all(f"force over ρV u̇, kR = {k_radius:g}, worse component", "–",
                        1.5 * u / np.linalg.norm(u), ours / unit, kDeepGoal, scale=1.5,
                        headline=k_radius == 1, kind="goal"),
            compare(f"torque over ρV u̇ R, kR = {k_radius:g}", "–", 0, torque / unit / radius,
                    kDeepGoal, scale=1, kind="goal")]
    result.plots.append(Plot("Force of waves on a deep sphere", "kR", "force / (ρ V u̇)", [
        Curve("exact", (0, 2), (1.5, 1.5), "k-"), Curve("", (0, 2), (1, 1), "k--"),
        Curve("ours", numbers, totals, "o"),
        Curve("ours, pressure alone", numbers, pressures, "s")]))
    return result


def on_hemisphere(plimsoll: Plimsoll, k_radius: float, subdivisions: int):
    """Complex heave and surge over ρ g π R² a, of the pressure and of both loads."""
    wave = DeepWave(kAmplitude, k_radius)
    changes = {"bodies[0].icosphere.subdivisions": subdivisions}
    crest, slope = (wave_loads(plimsoll, kHemisphere, wave, phase, changes) for phase in (0, 90))
    unit = 1000 * kGravity * np.pi * kAmplitude
    parts = [(crest[i] + 1j * slope[i]) / unit for i in (0, 1)]
    return abs(parts[0]), abs(parts[0] + parts[1])


kGoals = {"heave": (2, 0.01), "surge": (0, 0.01)}  # Component, and the goal for both loads.


def measure_hemisphere(plimsoll: Plimsoll) -> Result:
    result = Result()
    numbers, halved = (0.1, 0.3, 0.5, 1, 2), (0.1, 0.3, 0.5)
    ours = {kr: [on_hemisphere(plimsoll, kr, n) for n in (3, 4, 5)] for kr in numbers}
    for name, (axis, goal) in kGoals.items():
        exact = {kr: hemisphere_froude_krylov(kr)[0 if name == "heave" else 1] for kr in numbers}
        for kr in halved:
            result.rows += mesh_rows(f"pressure in {name}, kR = {kr:g}", "–", exact[kr],
                                     [one[0][axis] for one in ours[kr]], "20,480 triangles",
                                     headline=kr == 0.5)
        # In shorter waves a second term of the error, which is in k times the size, is as large.
        result.rows += [compare(f"pressure in {name}, kR = {kr:g}, 20,480 triangles", "–",
                                exact[kr], ours[kr][-1][0][axis], kFlatFaces, scale=1, kind="mesh")
                        for kr in numbers if kr not in halved]
        for kr in numbers:
            result.rows.append(
                compare(f"{name} of the held hemisphere, kR = {kr:g}", "–",
                        value(f"excitation.{name}.{kr:g}"), ours[kr][-1][1][axis],
                        goal, headline=kr == 0.3,
                        kind="goal"))
        line = np.linspace(0.02, 2, 60)
        result.plots.append(Plot(f"{name.capitalize()} of waves on a floating hemisphere", "kR",
                                 "force / (ρ g π R² a)", [
            Curve("pressure, exact", line, [hemisphere_froude_krylov(kr)[name == "surge"]
                                            for kr in line], "k--"),
            Curve("linear theory (WAMIT)", numbers,
                  [value(f"excitation.{name}.{kr:g}") for kr in numbers], "kx"),
            Curve("ours, pressure alone", numbers, [ours[kr][-1][0][axis] for kr in numbers], "s"),
            Curve("ours", numbers, [ours[kr][-1][1][axis] for kr in numbers], "o")]))
    return result


kCases = [
    Case("wave_force_deep", kSection, "Force of waves on a deep sphere",
         "A sphere of 0.5 m radius, 1.5 m below the water, in waves from ten to half its "
         "circumference; loads of the pressure and of the water that waves accelerate past the "
         "added mass.",
         "The mean of a harmonic function over a ball is its value at the centre: the pressure has "
         "ρV u̇, the potential of the sphere adds ½ρV u̇, and there is no moment, for any kR. The "
         "tolerance is that of the added mass.", [kDeep], measure_deep),
    Case("wave_force_hemisphere", kSection, "Forces of waves on a floating hemisphere",
         "A sphere of 1 m radius floats half immersed and is held. The pressure of the undisturbed "
         "wave is integrated over it; the program's own solution for the waves that it scatters "
         "gives the rest.",
         "Pressure: integrals over the hemisphere, by quadrature. The whole: WAMIT's exciting "
         "forces of a floating hemisphere; the goal is 1 %.", [kHemisphere],
         measure_hemisphere),
]
