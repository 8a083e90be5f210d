"""Bodies dropped flat must not turn by themselves (thesis, Figs 8 and 9), and where a small tilt
grows by the laws of physics it must grow at their rate."""

import numpy as np

from case import Case, Curve, Plot, Result, Row, compare
from closed_forms import cube_tilt_growth_rate, kGravity
from plimsoll import Plimsoll, Track, body_axis

kSection = "Buoyancy"


def spin(track: Track) -> np.ndarray:
    return np.linalg.norm(track.angular_velocity, axis=1)


def measure_drops(plimsoll: Plimsoll) -> Result:
    """The largest spin over the drop and what follows, without losses. A cube's is bounded by what
    round-off may have become after ten seconds of the true growth; a sphere has no such growth."""
    rate = cube_tilt_growth_rate(2, 0.55, kGravity)
    result = Result()
    curves = []
    for body, growth, style in (("sphere_480", 1, "-"), ("sphere_4900", 1, "-"),
                                ("cube_12", np.exp(10 * rate), "--"),
                                ("cube_768", np.exp(10 * rate), "--")):
        track = plimsoll.run_one(f"thesis_{body}.yaml", body)
        name = "{} of {} triangles".format(*body.split("_"))
        result.rows.append(Row(f"largest angular velocity, {name}", "rad/s", 0, spin(track).max(),
                               spin(track).max(), 1e-12 * growth, headline=body == "sphere_4900"))
        curves.append(Curve(name, track.t, np.maximum(spin(track), 1e-20), style))
    result.plots.append(Plot("Angular velocity after a drop from 2 m", "time [s]",
                             "angular velocity [rad/s]", curves, log_y=True))
    return result


def tilt_angle(track: Track) -> np.ndarray:
    """Between the body's z axis and the vertical [rad]."""
    axis = body_axis(track.quaternion, np.array([0.0, 0.0, 1.0]))
    return np.hypot(axis[:, 0], axis[:, 1])


def growth_row(track: Track, name: str, rate: float, headline: bool) -> Row:
    """From the slope of ln(tilt) while the tilt is between 1e-5 and 1e-3 rad: ten times its start,
    and small enough for the linear theory to hold to its square, 1e-6."""
    angle = tilt_angle(track)
    growing = (angle > 1e-5) & (angle < 1e-3)
    slope = np.polyfit(track.t[growing], np.log(angle[growing]), 1)[0]
    return compare(f"growth rate, {name}", "1/s", rate, slope, 1e-4, headline=headline)


def measure_growth(plimsoll: Plimsoll) -> Result:
    rate = cube_tilt_growth_rate(2, 0.55, kGravity)
    result = Result()
    curves = []
    for divisions, style in ((1, "o"), (8, "+")):
        track = plimsoll.run_one("validation/cube_tilt.yaml", f"tilt_{divisions}",
                                 {"bodies[0].box.divisions": divisions})
        name = f"{12 * divisions**2} triangles"
        result.rows.append(growth_row(track, name, rate, divisions == 8))
        shown = slice(0, None, 50)
        curves.append(Curve(name, track.t[shown], tilt_angle(track)[shown], style))
    diagonal = {"bodies[0].orientation.axis": [1, 1, 0],
                "bodies[0].angular_velocity": list(rate * 1e-6 / np.sqrt(2) * np.array([1, 1, 0]))}
    track = plimsoll.run_one("validation/cube_tilt.yaml", "tilt_diagonal", diagonal)
    result.rows.append(growth_row(track, "about a diagonal", rate, False))
    t = np.linspace(0, 10, 50)
    curves.append(Curve("exp(1.4703 t)", t, 1e-6 * np.exp(rate * t), "k-"))
    result.plots.append(Plot("Growth of a tilt of one microradian", "time [s]", "tilt [rad]",
                             curves, log_y=True))
    return result


kCases = [
    Case("spurious_spin", kSection, "A body dropped flat does not spin up",
         "Thesis, Figs 8 and 9: buoyancy alone, a drop from 2 m and ten seconds of bobbing. "
         "There, the sphere's angular velocity grew from step to step and more with more "
         "triangles. Forces placed at the triangles' centroids make such torques; exact first "
         "moments do not. A cube of relative density 0.55 is unstable when it floats flat, so "
         "round-off grows at the rate of the next case: its tolerance allows for that growth over "
         "the whole run.",
         "By symmetry there is no torque. The tolerance, in rad/s, is 1e-12, round-off of a "
         "torque of the size ρgVR acting for ten seconds; for the cubes times exp(1.4703 · 10).",
         ["thesis_sphere_480.yaml", "thesis_sphere_4900.yaml", "thesis_cube_12.yaml",
          "thesis_cube_768.yaml"], measure_drops),
    Case("tilt_growth", kSection, "A flat floating cube rights itself at the right rate",
         "What Fig. 8 of the thesis takes for numerical error is partly physics: a cube of "
         "relative density 0.55 is unstable afloat. It starts with a tilt of 1e-6 rad; the slope "
         "of the tilt's logarithm is compared with linear theory.",
         "With edge a = 2 m and draft d = 1.1 m, GM = d/2 + a²/(12 d) − a/2 = −0.1470 m and I = m "
         "a²/6, so σ² = −m g GM / I = −6 g GM / a² and σ = 1.4703 1/s, about any level axis.",
         ["validation/cube_tilt.yaml"], measure_growth),
]
