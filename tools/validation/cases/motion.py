"""Motion in time: sinking to a terminal velocity, bobbing."""

import numpy as np

from case import Case, Curve, Plot, Result, Row, compare, compare_all
from closed_forms import heave_period, kGravity
from plimsoll import Plimsoll

kSection = "Motion"


def extrapolated(values, sizes) -> float:
    """The limit of three values whose sizes halve, by Aitken's rule: it needs no order known."""
    a, b, c = values
    assert np.allclose([sizes[0] / sizes[1], sizes[1] / sizes[2]], 2)
    return c - (c - b)**2 / ((c - b) - (b - a))


def order_of(values) -> float:
    a, b, c = values
    return float(np.log2(abs((b - a) / (c - b))))


def at_least(quantity: str, least: float, order: float) -> Row:
    """Judges an order by what it lacks."""
    return Row(quantity, "–", least, order, max(0.0, least - order), 0.1)


def measure_terminal(plimsoll: Plimsoll) -> Result:
    """Cube of 1 m: front and back feel pressure drag, its four sides viscous drag."""
    terminal = np.sqrt(500 * kGravity / (1000 * (0.6316 + 2 * 0.1)))
    rate = 500 / 1500 * kGravity / terminal
    times = np.linspace(0.4, 4, 10)
    exact = terminal * np.tanh(rate * times)
    steps = (0.01, 0.005, 0.0025)
    tracks = [plimsoll.run_one("validation/falling_cube.yaml", f"step_{h}", {"step": h})
              for h in steps]
    speeds = [np.interp(times, track.t, -track.velocity[:, 2]) for track in tracks]
    late = plimsoll.run_one("validation/falling_cube.yaml", "late", {
        "duration": 30, "bodies[0].position": [0, 0, -2]})
    at = 1  # 0.8 s, where the speed still grows.
    limit = extrapolated([s[at] for s in speeds], steps)
    result = Result([
        compare("terminal velocity", "m/s", terminal, -late.velocity[-1, 2], 1e-12, headline=True),
        compare("speed at 0.8 s, steps 10, 5 and 2.5 ms extrapolated", "m/s", exact[at], limit,
                1e-5, headline=True),
        compare_all("speed at ten times, step 2.5 ms, worst", "m/s", exact, speeds[-1], 2e-3,
                    scale=terminal),
        at_least("order of the error with the step, at least", 1,
                 order_of([s[at] for s in speeds]))])
    shown = slice(0, None, 40)
    result.plots.append(Plot("Speed of a sinking cube", "time [s]", "speed [m/s]", [
        Curve("tanh law", np.linspace(0, 4, 100), terminal * np.tanh(rate * np.linspace(0, 4, 100)),
              "k-"),
        Curve("ours, 2.5 ms", tracks[-1].t[shown], -tracks[-1].velocity[shown, 2], "o")]))
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


def measure_period(plimsoll: Plimsoll) -> Result:
    """The errors of step and mesh add up, to the first order in each: both are extrapolated."""
    exact = heave_period(0.15, 7.056, 998.2, 9.82, 0.03)
    steps, counts = (0.008, 0.004, 0.002), (32, 64, 128)
    of_step = [bobbing_period(plimsoll, 64, h) for h in steps]
    of_mesh = [bobbing_period(plimsoll, n, 0.002) for n in counts]
    limit = (extrapolated(of_step, steps) - of_step[-1]) + extrapolated(of_mesh, [4, 2, 1])
    result = Result([
        compare("period, step and mesh extrapolated", "s", exact, limit, 2e-5, headline=True),
        compare("period, step 2 ms, 32,512 triangles", "s", exact, of_mesh[-1], 1e-3),
        at_least("order of the error with the step, at least", 1, order_of(of_step)),
        compare("order of the error with the panels' size", "–", 2, order_of(of_mesh), 0.1,
                scale=1)])
    result.plots.append(Plot("Error of the period", "step [s]", "relative error", [
        Curve("against the limit of small steps", steps[:2],
              np.abs(np.array(of_step[:2]) / extrapolated(of_step, steps) - 1), "o-")],
        log_x=True, log_y=True))
    return result


kCases = [
    Case("terminal_velocity", kSection, "A sinking cube",
         "A cube of 1 m and 1,500 kg/m³, face down, from rest, without added mass. Three time "
         "steps show the order of the time stepping; their extrapolation has none of its error.",
         "With K = ρa²(C_p + 2C_v): m dv/dt "
         "= (m − ρV)g − Kv², so v = "
         "v<sub>t</sub> tanh(t (m − ρV)g/(m "
         "v<sub>t</sub>)), v<sub>t</sub>² = "
         "(m − ρV)g/K.", ["validation/falling_cube.yaml"], measure_terminal),
    Case("heave_period", kSection, "Period of a bobbing sphere at finite amplitude",
         "R = 0.15 m, m = 7.056 kg, ρ = 998.2 kg/m³, g = 9.82 m/s², let go 30 mm above its rest; "
         "buoyancy alone. Step and mesh are halved twice each and extrapolated.",
         "Conservation of energy gives v(z), and the period as a quadrature: 0.63725 s.",
         ["validation/bobbing_sphere.yaml"], measure_period),
]
