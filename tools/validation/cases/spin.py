"""Drag of spinning bodies, and how it slows them down (thesis, Fig. 12)."""

import numpy as np

from case import Case, Curve, Plot, Result, compare, compare_all, observed_order
from closed_forms import (cube_spin_pressure_torque, cube_spin_viscous_torque, integrate,
                          sphere_spin_torque, sphere_spin_torque_of_law,
                          thesis_viscous_coefficient)
from plimsoll import Plimsoll

kSection = "Drag and lift"
kSphere = "validation/spin_sphere.yaml"


def measure_torque(plimsoll: Plimsoll) -> Result:
    result = Result()
    unit = {"hydro.pressure_drag": 1, "hydro.viscous_drag": 1}
    for divisions in (1, 5):
        cube = plimsoll.probe_one("validation/spin_cube.yaml",
                                  {**unit, "bodies[0].box.divisions": divisions})
        name = f"cube of {12 * divisions**2} triangles"
        result.rows += [
            compare(f"pressure torque, {name}", "N m", cube_spin_pressure_torque(2, 3, 1000, 1),
                    -cube.pressure_drag.torque[2], 1e-12, headline=divisions == 1),
            compare(f"viscous torque, {name}", "N m", cube_spin_viscous_torque(2, 3, 1000, 1),
                    -cube.viscous_drag.torque[2], 1e-5, headline=divisions == 1)]
    errors = []
    exact = sphere_spin_torque(1, 3, 1000, 1)
    for count in (24, 48, 96):
        sphere = plimsoll.probe_one(kSphere, {
            **unit, "bodies[0].sphere.slices": count, "bodies[0].sphere.stacks": count,
            "bodies[0].angular_velocity": [0, 0, 3]})
        errors.append(-sphere.viscous_drag.torque[2] / exact - 1)
    result.rows += [compare("viscous torque, sphere of 18,240 triangles", "N m", exact,
                            exact * (1 + errors[-1]), 5e-3, headline=True),
                    observed_order("order of the error, sphere", errors, 0.05)]
    return result


def decay(moment: float, start: float, times: np.ndarray, torque) -> np.ndarray:
    """Angular velocity after the applied torque of the scene [rad/s]."""
    applied = lambda t: 50000 if t < 0.1 else 0
    return integrate(lambda t, w: (applied(t) - np.sign(w) * torque(w)) / moment, start, times)


def measure_decay(plimsoll: Plimsoll) -> Result:
    """The drag of a smooth sphere with the moment of inertia that the mesh has, 0.7 % less."""
    moment = plimsoll.probe_one(kSphere).inertia[2, 2]
    laws = (("C_v = 0.1", 0.1, lambda w: sphere_spin_torque(1, w, 1000, 0.1)),
            ("C_v of the thesis", "thesis",
             lambda w: sphere_spin_torque_of_law(1, w, 1000, thesis_viscous_coefficient)))
    times = np.linspace(0, 10, 501)
    result = Result()
    curves = []
    for name, law, torque in laws:
        overrides = {"hydro.viscous_drag": law, "hydro.pressure_drag": False, "step": 0.005,
                     "log.every": 0.02}
        track = plimsoll.run_one(kSphere, f"decay_{law}", overrides)
        exact = decay(moment, 0, times, torque)
        late = times > 0.15
        ours = np.interp(times, track.t, track.angular_velocity[:, 2])
        result.rows.append(compare_all(f"angular velocity, {name}, worst over 10 s", "rad/s",
                                       exact[late], ours[late], 5e-3, scale=exact.max(),
                                       headline=law == "thesis"))
        curves += [Curve(f"smooth sphere, {name}", times, exact, "k-" if law == 0.1 else "k--"),
                   Curve(f"ours, {name}", track.t[::12], track.angular_velocity[::12, 2], "o")]
    free = plimsoll.run_one(kSphere, "decay_none", {"hydro.viscous_drag": False,
                                                    "log.every": 0.02})
    curves.append(Curve("ours, without viscous drag", free.t[::12],
                        free.angular_velocity[::12, 2], "+"))
    result.plots.append(Plot("Spin-down of a sphere", "time [s]", "angular velocity [rad/s]",
                             curves))
    return result


kCases = [
    Case("spin_torque", kSection, "Torque on spinning cubes and spheres",
         "A cube about an axis through two faces, a sphere about a diameter, at 3 rad/s.",
         "Cube of edge a: pressure ρC_pω²a⁵/16; viscous ρC_vω²a⁵(1/4 + ∫r³dA) over the unit "
         "square, = 0.328398. Sphere: (3π²/8)ρC_vω²R⁵. The pressure's is exact on flat panels; "
         "viscous drag is no polynomial, and its quadrature promises 1e-5.",
         ["validation/spin_cube.yaml", kSphere], measure_torque),
    Case("spin_down", kSection, "Spin-down of a sphere",
         "Thesis, Fig. 12: a sphere held 3 m deep, set spinning by 50,000 N m for 0.1 s, with and "
         "without viscous drag. Without it, what is left is the pressure drag of the facets.",
         "I dω/dt = M(t) − τ(ω), with τ = (3π²/8)ρC_vω²R⁵ for constant C_v, which has the "
         "solution ω = ω<sub>0</sub>/(1 + kω<sub>0</sub>t), and by quadrature over the sphere for "
         "the thesis's C_v. I is that of the mesh, 0.7 % less than the sphere's; the facets' "
         "pressure drag is left out of the compared runs. The tolerance is what the mesh's viscous "
         "drag lacks of the sphere's, 0.8 %, as it adds up.",
         [kSphere], measure_decay),
]
