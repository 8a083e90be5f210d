"""Drag of spinning bodies, and how it slows them down (thesis, Fig. 12)."""

import numpy as np

from case import Case, Curve, Plot, Result, Row, compare
from closed_forms import (cube_spin_pressure_torque, cube_spin_viscous_torque, integrate,
                          sphere_spin_torque)
from convergence import mesh_rows, track_rows
from plimsoll import Plimsoll
from uv_sphere import SpinningSphere

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
                    -cube.viscous_drag.torque[2], 1e-12, headline=divisions == 1)]
    torques = [sphere_torque(plimsoll, count, 1) for count in (24, 48, 96)]
    result.rows += mesh_rows("viscous torque, sphere", "N m", sphere_spin_torque(1, 3, 1000, 1),
                             torques, "18,240 triangles", headline=True)
    polyhedron = SpinningSphere(1, 24, 24)
    result.rows += [
        compare("viscous torque, polyhedron of 1,104 triangles", "N m",
                polyhedron.torque(3, 1000, 1), torques[0], 1e-9),
        compare("the same with the thesis's C_v", "N m", polyhedron.torque_of_thesis_law(3, 1000),
                sphere_torque(plimsoll, 24, "thesis"), kKinks, kind="raster")]
    return result


# The reference's quadrature sums C_v v^2 on 48 x 48 points a panel across its kinks, where one
# cell in some ten errs by the square of its size, (1/48)^2/12, and not all to the same side.
kKinks = 1e-5


def sphere_torque(plimsoll: Plimsoll, count: int, law) -> float:
    """-M_z at 3 rad/s [N m]."""
    sphere = plimsoll.probe_one(kSphere, {
        "hydro.viscous_drag": law, "bodies[0].sphere.slices": count,
        "bodies[0].sphere.stacks": count, "bodies[0].angular_velocity": [0, 0, 3]})
    return -sphere.viscous_drag.torque[2]


kCount = 24  # Slices and stacks of the sphere that is compared.
kTimes = np.linspace(0, 10, 501)
kSpin = 5.4  # What the torque of the scene leaves, about [rad/s].
kSpinning = {"bodies[0].angular_velocity": [0, 0, kSpin], "bodies[0].forces": []}
kSteps = (0.01, 0.005, 0.0025)
# For the spin-up, which is over after 0.1 s: longer ones are not yet of their order.
kShortSteps = (0.00125, 0.000625, 0.0003125)
kDensityError = 0.01  # What the comparison must be able to see.


def decay(torque, start: float, push: float = 0) -> np.ndarray:
    """Angular velocity of the scene's sphere at kTimes [rad/s], by 16 steps between two of them;
    `push` [N m] for the first tenth of a second."""
    moment = SpinningSphere(1, kCount, kCount).moment_of_inertia(550)
    applied = lambda t: push if t < 0.1 else 0
    fine = np.linspace(kTimes[0], kTimes[-1], 16 * (len(kTimes) - 1) + 1)
    return integrate(lambda t, w: (applied(t) - np.sign(w) * torque(w)) / moment, start, fine)[::16]


def spin_down(plimsoll: Plimsoll, law, step: float, changes: dict) -> np.ndarray:
    """The same by the program at kTimes, without the pressure drag of the facets."""
    name = f"decay_{law}_{step}_{changes.get('water.density', '')}_{len(changes)}"
    track = plimsoll.run_one(kSphere, name, {
        "hydro.viscous_drag": law, "hydro.pressure_drag": False, "step": step, "log.every": 0.02,
        "bodies[0].sphere.slices": kCount, "bodies[0].sphere.stacks": kCount, **changes})
    return np.interp(kTimes, track.t, track.angular_velocity[:, 2])


def measure_decay(plimsoll: Plimsoll) -> Result:
    """The spin-up is compared with constant C_v alone: friction by the thesis's C_v acts for two
    or three steps of it only, too few to extrapolate from. What is lost afterwards is measured on
    a sphere that starts at kSpin."""
    polyhedron = SpinningSphere(1, kCount, kCount)
    laws = (("C_v = 0.1", 0.1, lambda w: polyhedron.torque(w, 1000, 0.1), 1e-9, "k-"),
            ("C_v of the thesis", "thesis", lambda w: polyhedron.torque_of_thesis_law(w, 1000),
             kKinks, "k--"))
    result = Result()
    curves = []
    for name, law, torque, floor, style in laws:
        if law == 0.1:
            spun_up = [spin_down(plimsoll, law, step, {}) for step in kShortSteps]
            result.rows += track_rows(f"angular velocity, {name}, spin-up and decay", "rad/s",
                                      decay(torque, 0, push=50000), spun_up, floor)
        lost = [spin_down(plimsoll, law, step, kSpinning) - kSpin for step in kSteps]
        exact = decay(torque, kSpin)
        rows = track_rows(f"angular velocity lost, {name}", "rad/s", exact - kSpin, lost, floor,
                          headline=True)
        result.rows += [*rows, density_row(plimsoll, law, name, lost[2], rows[0])]
        curves += [Curve(f"polyhedron, {name}", kTimes, exact, style),
                   Curve(f"ours, {name}", kTimes[::12], kSpin + lost[2][::12], "o")]
    free = plimsoll.run_one(kSphere, "decay_none", {"hydro.viscous_drag": False,
                                                    "log.every": 0.02, **kSpinning})
    curves.append(Curve("ours, pressure drag alone", free.t[::12],
                        free.angular_velocity[::12, 2], "+"))
    result.plots.append(Plot("Spin-down of a sphere", "time [s]", "angular velocity [rad/s]",
                             curves))
    return result


def density_row(plimsoll: Plimsoll, law, name: str, right: np.ndarray, row: Row) -> Row:
    """That water 1 % too dense would fail the row: it moves the loss by more than twice the
    tolerance."""
    dense = {**kSpinning, "water.density": 1000 * (1 + kDensityError)}
    wrong = spin_down(plimsoll, law, kSteps[2], dense) - kSpin
    times = float(np.abs(wrong - right).max() / np.ptp(right) / row.tolerance)
    return Row(f"what 1 % more density does, over the tolerance, {name}, at least", "–", 2, times,
               max(0.0, 2 - times), 0.0)


kCases = [
    Case("spin_torque", kSection, "Torque on spinning cubes and spheres",
         "A cube about an axis through two faces, a sphere about a diameter, at 3 rad/s.",
         "Cube of edge a: pressure ρC_pω²a⁵/16; viscous ρC_vω²a⁵(1/4 + ∫r³dA) over the unit "
         "square, (7√2/8 + ⅜ ln(1 + √2))/20: 0.3283979… in all. Sphere: (3π²/8)ρC_vω²R⁵. The "
         "polyhedron that the mesh of the sphere is: quadrature over its own panels, made without "
         "the program.",
         ["validation/spin_cube.yaml", kSphere], measure_torque),
    Case("spin_down", kSection, "Spin-down of a sphere",
         "Thesis, Fig. 12: a sphere held 3 m deep, set spinning by 50,000 N m for 0.1 s, with and "
         "without viscous drag. Without it, what is left is the pressure drag of the facets.",
         "I dω/dt = M(t) − τ(ω), by the method of Runge and Kutta. I and τ are those of the "
         "polyhedron of 1,104 triangles, its tetrahedra summed and its friction by quadrature over "
         "its panels, both without the program; what is left is the time stepping, which three "
         "steps extrapolate. The facets' pressure drag is left out of the compared runs. A last "
         "row shows that water 1 % too dense would be noticed.",
         [kSphere], measure_decay),
]
