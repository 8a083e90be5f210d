"""Bodies dropped flat must not turn by themselves (thesis, Figs 8 and 9), and where a small tilt
grows by the laws of physics it must grow at their rate."""

import numpy as np

from case import Case, Curve, Plot, Result, Row
from closed_forms import cube_tilt_growth_rate, kGravity
from convergence import step_rows
from plimsoll import Plimsoll, Track, body_axis

kSection = "Buoyancy"


def spin(track: Track) -> np.ndarray:
    return np.linalg.norm(track.angular_velocity, axis=1)


def measure_drops(plimsoll: Plimsoll) -> Result:
    """The largest spin over the drop and what follows, without losses. Round-off in a cube's spin
    grows as a true tilt does, by exp(rate t); a sphere has no such growth."""
    rate = cube_tilt_growth_rate(2, 0.55, kGravity)
    result = Result()
    curves = []
    for body, growth, style in (("sphere_480", 0, "-"), ("sphere_4900", 0, "-"),
                                ("cube_12", rate, "--"), ("cube_768", rate, "--")):
        track = plimsoll.run_one(f"thesis_{body}.yaml", body)
        name = "{} of {} triangles".format(*body.split("_"))
        largest = np.max(spin(track) * np.exp(-growth * track.t))
        over = f", over exp({growth:.4f} t)" if growth else ""
        result.rows.append(Row(f"largest angular velocity{over}, {name}", "rad/s", 0, largest,
                               largest, 1e-12, headline=body == "sphere_4900"))
        curves.append(Curve(name, track.t, np.maximum(spin(track), 1e-20), style))
    result.plots.append(Plot("Angular velocity after a drop from 2 m", "time [s]",
                             "angular velocity [rad/s]", curves, log_y=True))
    return result


def tilt_angle(track: Track) -> np.ndarray:
    """Between the body's z axis and the vertical [rad]."""
    axis = body_axis(track.quaternion, np.array([0.0, 0.0, 1.0]))
    return np.hypot(axis[:, 0], axis[:, 1])


kSteps = (0.01, 0.005, 0.0025)
kSmallest, kLargest = 1e-6, 1e-4  # Tilts between which the growth is measured [rad].
# The tilt starts at a thousandth of the smallest, so that of whatever else than growth the start
# contains a millionth is left; linear theory holds to the square of the largest.
kStart = 1e-9
kLinear = kLargest**2


def growth(plimsoll: Plimsoll, name: str, axis: np.ndarray, step: float, overrides: dict):
    """The slope of ln(tilt) [1/s], and the run."""
    rate = cube_tilt_growth_rate(2, 0.55, kGravity)
    track = plimsoll.run_one("validation/cube_tilt.yaml", f"{name}_{step}", {
        **overrides, "step": step, "bodies[0].orientation.axis": list(axis),
        "bodies[0].orientation.angle_deg": float(np.degrees(kStart)),
        "bodies[0].angular_velocity": list(rate * kStart * axis / np.linalg.norm(axis))})
    angle = tilt_angle(track)
    growing = (angle > kSmallest) & (angle < kLargest)
    return np.polyfit(track.t[growing], np.log(angle[growing]), 1)[0], track


def measure_growth(plimsoll: Plimsoll) -> Result:
    rate = cube_tilt_growth_rate(2, 0.55, kGravity)
    result = Result()
    curves = []
    for name, divisions, axis, style in (("12 triangles", 1, (1.0, 0.0, 0.0), "o"),
                                         ("768 triangles", 8, (1.0, 0.0, 0.0), "+"),
                                         ("768 triangles, about a diagonal", 8, (1.0, 1.0, 0.0),
                                          "x")):
        runs = [growth(plimsoll, name.replace(" ", "_"), np.array(axis), step,
                       {"bodies[0].box.divisions": divisions}) for step in kSteps]
        result.rows += step_rows(f"growth rate, {name}", "1/s", rate, [run[0] for run in runs],
                                 kLinear, headline=name == "768 triangles")
        track = runs[-1][1]
        shown = slice(0, None, 100)
        curves.append(Curve(name, track.t[shown], tilt_angle(track)[shown], style))
    t = np.linspace(0, 12, 50)
    curves.append(Curve(f"exp({rate:.4f} t)", t, kStart * np.exp(rate * t), "k-"))
    result.plots.append(Plot("Growth of a tilt of one nanoradian", "time [s]", "tilt [rad]",
                             curves, log_y=True))
    return result


kCases = [
    Case("spurious_spin", kSection, "A body dropped flat does not spin up",
         "Thesis, Figs 8 and 9: buoyancy alone, a drop from 2 m and ten seconds of bobbing. "
         "There, the sphere's angular velocity grew from step to step and more with more "
         "triangles. Forces placed at the triangles' centroids make such torques; exact first "
         "moments do not. A cube of relative density 0.55 is unstable when it floats flat, so "
         "round-off grows at the rate of the next case: a cube's spin is divided by that growth.",
         "By symmetry there is no torque. The tolerance, in rad/s, is 1e-12, round-off of a "
         "torque of the size ρgVR acting for ten seconds.",
         ["thesis_sphere_480.yaml", "thesis_sphere_4900.yaml", "thesis_cube_12.yaml",
          "thesis_cube_768.yaml"], measure_drops),
    Case("tilt_growth", kSection, "A flat floating cube rights itself at the right rate",
         "What Fig. 8 of the thesis takes for numerical error is partly physics: a cube of "
         "relative density 0.55 is unstable afloat. It starts with a tilt of 1e-9 rad; the slope "
         "of the tilt's logarithm between 1e-6 and 1e-4 rad is compared with linear theory, which "
         "holds to 1e-8 there. Three steps show what the time stepping does to it.",
         "With edge a = 2 m and draft d = 1.1 m, GM = d/2 + a²/(12 d) − a/2 = −0.1470 m and I = m "
         "a²/6, so σ² = −m g GM / I = −6 g GM / a² and σ = 1.4703 1/s, about any level axis.",
         ["validation/cube_tilt.yaml"], measure_growth),
]
