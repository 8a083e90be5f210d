"""Motion in time: sinking to a terminal velocity, bobbing."""

from dataclasses import dataclass, replace

import numpy as np

from case import Case, Curve, Plot, Result, compare
from closed_forms import heave_period, kGravity
from convergence import (extrapolated, mesh_rows, step_order_rows, track_rows,
                         whole_order)
from plimsoll import Plimsoll

kSection = "Motion"
kSteps = (0.01, 0.005, 0.0025)


@dataclass(frozen=True)
class Sinker:
    """A box of 1 m³ and 1500 kg/m³ that sinks from rest; the integrals over its faces of
    |n_z|^3 and of |t_z|^3, t the tangential part of the upward unit vector [m^2]."""

    name: str
    title: str
    pressure_area: float
    viscous_area: float
    overrides: dict

    @property
    def terminal_speed(self) -> float:
        drag = 500 * (0.6316 * self.pressure_area + 0.1 * self.viscous_area)
        return float(np.sqrt(500 * kGravity / drag))

    def speed(self, t):
        rate = 500 / 1500 * kGravity / self.terminal_speed
        return self.terminal_speed * np.tanh(rate * t)


# Face down: two faces square to the way, four along it. Edge down: four faces at 45 degrees, on
# which both parts of the velocity are v/sqrt(2), and two along the way. A plate: as face down.
kSinkers = (
    Sinker("cube_face", "cube, face down", 2, 4, {}),
    Sinker("cube_edge", "cube, edge down", np.sqrt(2), 2 + np.sqrt(2), {
        "bodies[0].orientation": {"euler_deg": [45, 0, 0]}, "bodies[0].lock": ["roll", "pitch"]}),
    Sinker("plate", "plate of 2 × 2 × 0.25 m, face down", 8, 2, {
        "bodies[0].box.size": [2, 2, 0.25], "bodies[0].lock": ["roll", "pitch"]}))


def measure_terminal(plimsoll: Plimsoll) -> Result:
    result = Result()
    curves = []
    times = np.linspace(0.4, 4, 10)
    for sinker, style in zip(kSinkers, ("o", "s", "^")):
        tracks = [plimsoll.run_one("validation/falling_cube.yaml", f"{sinker.name}_{h}",
                                   {**sinker.overrides, "step": h}) for h in kSteps]
        speeds = [np.interp(times, track.t, -track.velocity[:, 2]) for track in tracks]
        late = plimsoll.run_one("validation/falling_cube.yaml", f"{sinker.name}_late",
                                {**sinker.overrides, "duration": 30})
        result.rows += [
            compare(f"terminal velocity, {sinker.title}", "m/s", sinker.terminal_speed,
                    -late.velocity[-1, 2], 1e-12, headline=True),
            *track_rows(f"speed at ten times, {sinker.title}", "m/s", sinker.speed(times), speeds,
                        1e-9, headline=sinker.name == "cube_face")]
        axis = np.linspace(0, 4, 100)
        shown = slice(0, None, 40)
        curves += [Curve("" if curves else "tanh law", axis, sinker.speed(axis), "k-"),
                   Curve(sinker.title, tracks[-1].t[shown], -tracks[-1].velocity[shown, 2],
                         style)]
    result.plots.append(Plot("Speed of sinking boxes", "time [s]", "speed [m/s]", curves))
    return result


def crossings(t: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Times at which z passes through its mean value upwards, by a cubic through four points."""
    level = 0.5 * (z.max() + z.min())
    times = []
    for i in range(1, len(z) - 2):
        if z[i] < level <= z[i + 1]:
            points = slice(i - 1, i + 3)
            times.append(t[i] + cubic_root(t[points] - t[i], z[points] - level))
    return np.array(times)


def cubic_root(t: np.ndarray, z: np.ndarray) -> float:
    """Root between the second and the third of four points, taking t as a cubic of z."""
    total = 0.0
    for i in range(4):
        others = [j for j in range(4) if j != i]
        total += t[i] * np.prod([-z[j] / (z[i] - z[j]) for j in others])
    return float(total)


def bobbing_period(plimsoll: Plimsoll, count: int, step: float) -> float:
    """Mean over five periods [s]."""
    track = plimsoll.run_one("validation/bobbing_sphere.yaml", f"bob_{count}_{step}", {
        "step": step, "duration": 3.8, "bodies[0].sphere.slices": count,
        "bodies[0].sphere.stacks": count})
    times = crossings(track.t, track.position[:, 2])
    return (times[5] - times[0]) / 5


# The crossings are found by cubics, which err by 3/128 of the fourth power of the phase in a step,
# 2 pi 0.002/0.637: by 3.5e-9 of the 31 radians in five periods.
kCrossings = 1e-9


def measure_period(plimsoll: Plimsoll) -> Result:
    """The errors of step and mesh add up, to the first order in each: both are extrapolated."""
    exact = heave_period(0.15, 7.056, 998.2, 9.82, 0.03)
    steps, counts = (0.008, 0.004, 0.002), (32, 64, 128)
    of_step = [bobbing_period(plimsoll, 64, h) for h in steps]
    of_mesh = [bobbing_period(plimsoll, n, 0.002) for n in counts]
    result = Result()
    step_limit, doubt = extrapolated(of_step, whole_order(of_step))
    both = [period + step_limit - of_step[-1] for period in of_mesh]
    rows = mesh_rows("period in the limit of small steps", "s", exact, both, "32,512 triangles")
    rows = [replace(row, tolerance=row.tolerance + share * (doubt / exact + kCrossings))
            for row, share in zip(rows, (1, 0, 1))]
    rows[2] = replace(rows[2], headline=True)
    result.rows += rows + step_order_rows("8,064 triangles", of_step, kCrossings)
    result.plots.append(Plot("Error of the period", "step [s]", "relative error", [
        Curve("against the limit of small steps", steps,
              np.abs(np.array(of_step) / step_limit - 1), "o-")], log_x=True, log_y=True))
    return result


kCases = [
    Case("terminal_velocity", kSection, "Sinking boxes",
         "A cube and a plate of 1 m³ and 1,500 kg/m³, from rest, without added mass; the cube face "
         "down and edge down. Three time steps show the order of the time stepping; their "
         "extrapolation has little of its error.",
         "With K = ½ρ(C_p A_p + C_v A_v): m dv/dt = (m − ρV)g − Kv², so v = v<sub>t</sub> "
         "tanh(t (m − ρV)g/(m v<sub>t</sub>)), v<sub>t</sub>² = (m − ρV)g/K. A_p and A_v, the "
         "integrals of |n_z|³ and |t_z|³: 2 and 4 m² face down, √2 and 2 + √2 m² edge down, 8 and "
         "2 m² for the plate.", ["validation/falling_cube.yaml"], measure_terminal),
    Case("heave_period", kSection, "Period of a bobbing sphere at finite amplitude",
         "R = 0.15 m, m = 7.056 kg, ρ = 998.2 kg/m³, g = 9.82 m/s², let go 30 mm above its rest; "
         "buoyancy alone. Step and mesh are halved twice each and extrapolated.",
         "Conservation of energy gives v(z), and the period as a quadrature: 0.63725 s.",
         ["validation/bobbing_sphere.yaml"], measure_period),
]
