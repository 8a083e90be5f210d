"""What must not depend on where the scene stands, how its water moves or how its sea lies."""

import numpy as np

from case import Case, Curve, Plot, Result, compare_all, compare_vectors
from closed_forms import kGravity
from plimsoll import Body, Plimsoll

kSection = "Sea and frames"
kLoads = ("buoyancy", "pressure_drag", "viscous_drag", "lift")


def measure_slope(plimsoll: Plimsoll) -> Result:
    """The sea of the scene: z = x/8 - y/16. Half-immersed: a box whose walls alone meet the water
    displaces its section times the depth under its axis."""
    scene = "validation/sloping_sea.yaml"
    up = np.array([-1 / 8, 1 / 16, 1])
    turned = {"bodies[0].orientation": {"euler_deg": [20, -35, 30]}}
    cases = [
        ("box, submerged and turned", {**turned, "bodies[0].position": [0.5, -0.25, -3]}, 8),
        ("sphere of 480 triangles, submerged", {
            "bodies[0]": {"name": "body", "density": 500, "position": [0.5, -0.25, -3],
                          "sphere": {"radius": 1, "slices": 16, "stacks": 16}}}, None),
        ("upright box, half immersed", {}, 4 * (1 + 0.5 / 8 + 0.25 / 16)),
    ]
    result = Result()
    for name, overrides, volume in cases:
        body = plimsoll.probe_one(scene, overrides)
        if volume is None:
            volume = body.mass / 500
        result.rows.append(compare_vectors(f"buoyancy, {name}", "N", 1000 * kGravity * volume * up,
                                           body.buoyancy.force, 1e-13,
                                           headline=name.startswith("upright")))
    return result


def measure_current(plimsoll: Plimsoll) -> Result:
    scene = "validation/tumbling_box.yaml"
    current = np.array([0.75, -0.5, 0])
    drifting = plimsoll.run_one(scene, "current")
    still = plimsoll.run_one(scene, "still", {"water.current": [0, 0, 0],
                                              "bodies[0].linear_velocity": [0, 0, 0]})
    moved = drifting.position - np.outer(drifting.t, current)
    spin = np.abs(drifting.angular_velocity - still.angular_velocity).max(axis=1)
    carried = plimsoll.probe_one(scene, {"bodies[0].position": [0, 0, -3],
                                         "bodies[0].angular_velocity": [0, 0, 0]})
    result = Result([
        compare_all("position after subtracting the current, worst over 4 s", "m",
                    still.position.ravel(), moved.ravel(), 1e-11, scale=1, headline=True),
        compare_all("velocity after subtracting the current, worst", "m/s", still.velocity.ravel(),
                    (drifting.velocity - current).ravel(), 1e-11, scale=1),
        compare_all("angular velocity, worst", "rad/s", still.angular_velocity.ravel(),
                    drifting.angular_velocity.ravel(), 1e-11, scale=1),
        compare_vectors("drag and lift of a body that the current carries", "N", np.zeros(3),
                        sum(getattr(carried, name).force for name in kLoads[1:]), 0.0, scale=1)])
    result.plots.append(Plot("Differences between the two runs", "time [s]", "difference", [
        Curve("position [m]", still.t[1:],
              np.maximum(np.abs(moved - still.position).max(axis=1)[1:], 1e-18)),
        Curve("angular velocity [rad/s]", still.t[1:], np.maximum(spin[1:], 1e-18))], log_y=True))
    return result


def load_of(body: Body, name: str) -> np.ndarray:
    load = getattr(body, name)
    return np.concatenate([load.force, load.torque])


def measure_far(plimsoll: Plimsoll) -> Result:
    """At 1e6 m a position is rounded by up to 6e-11 m. Half immersed, a load changes by no more
    than ten times itself per metre of depth."""
    scene = "validation/far_from_origin.yaml"
    far = plimsoll.probe_one(scene)
    near = plimsoll.probe_one(scene, {"water.level": 0, "bodies[0].position": [0.1, -0.3, 0.07]})
    return Result([
        compare_vectors(f"{name.replace('_', ' ')}, force and torque", "N, N m",
                        load_of(near, name), load_of(far, name), np.spacing(1e6) / 2 * 10,
                        headline=name == "buoyancy")
        for name in kLoads])


kCases = [
    Case("sloping_sea", kSection, "A sea that slopes as a plane",
         "The sea is the height field z = x/8 − y/16. A triangle takes the depth at each of its "
         "vertices, so that a plane is no approximation.",
         "By Gauss's theorem the pressure ρg(ξ − z) pushes with ρgV(−s<sub>x</sub>, "
         "−s<sub>y</sub>, 1), also on a body that is partly immersed.",
         ["validation/sloping_sea.yaml"], measure_slope),
    Case("current", kSection, "A uniform current changes nothing but the place",
         "A heavy box falls through the surface and tumbles, in still water, and in a current "
         "with the current's velocity added to it at the start.",
         "Galilean invariance: the two motions differ by c t. Round-off grows with the tumbling, "
         "hence 1e-11 m, m/s and rad/s. A body that does not move through the water feels no drag "
         "at all.",
         ["validation/tumbling_box.yaml"], measure_current),
    Case("far_from_origin", kSection, "A million metres from the origin",
         "The loads on a moving, half-immersed box with everything shifted by 1,000 km along x, y "
         "and z, the water's level too.",
         "Loads do not depend on the origin. The tolerance is what rounding a position at 1e6 m "
         "to a double costs: 6e-11 m, times a load's relative change with depth, up to 10 a metre.",
         ["validation/far_from_origin.yaml"], measure_far),
]
