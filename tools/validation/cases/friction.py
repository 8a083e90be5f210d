"""Friction of a plate by the ITTC 1957 line."""

import numpy as np

from case import Case, Curve, Plot, Result, compare, compare_vectors
from cases.calibrated import rotation
from closed_forms import ittc57
from plimsoll import Plimsoll

kScene = "validation/friction_plate.yaml"
kSize = (4.0, 0.01, 1.0)
kViscosity = 1.0e-6
kSpeeds = (1e-4, 2e-3, 2.6e-3, 0.01, 0.1, 0.5, 1, 3, 10)  # Up to Re = 4e7; 1e4 is at 0.0025.
kRoundOff = 1e-12


def wetted_surface() -> float:
    """The sides along which the plate moves, and both long edges; fore and aft edge move square to
    themselves, without friction [m^2]."""
    length, thickness, height = kSize
    return 2 * length * (height + thickness)


def friction(speed: float, length: float) -> float:
    """[N]"""
    return 500 * ittc57(speed * length / kViscosity) * wetted_surface() * speed**2


def measure(plimsoll: Plimsoll) -> Result:
    result = Result()
    ours = []
    for length in (None, 2.5):
        overrides = {} if length is None else {"hydro.length": length}
        title = "length left out: 4 m" if length is None else f"length {length} m"
        for speed in kSpeeds:
            body = plimsoll.probe_one(kScene, {
                **overrides, "bodies[0].linear_velocity": [speed, 0, 0]})
            drag, exact = -body.viscous_drag.force[0], friction(speed, length or kSize[0])
            reynolds = speed * (length or kSize[0]) / kViscosity
            result.rows.append(compare(
                f"friction at Re = {reynolds:.2g}, {title}", "N", exact, drag, kRoundOff,
                headline=length is None and speed == 3))
            ours += [drag / (500 * wetted_surface() * speed**2)] if length is None else []
    result.rows.append(turned_row(plimsoll))
    result.plots.append(figure(ours))
    return result


def turned_row(plimsoll: Plimsoll):
    """The same plate in any attitude, moving along itself."""
    ahead = rotation(20, -35, 50)[:, 0]
    body = plimsoll.probe_one(kScene, {
        "bodies[0].orientation.euler_deg": [20, -35, 50],
        "bodies[0].linear_velocity": list(3 * ahead)})
    return compare_vectors("friction at 3 m/s, plate turned anyhow", "N",
                           -friction(3, kSize[0]) * ahead, body.viscous_drag.force, kRoundOff)


def figure(ours: list[float]) -> Plot:
    reynolds = np.geomspace(1e2, 1e8, 200)
    return Plot("Friction of a plate of 4 m", "Reynolds number", "friction coefficient", [
        Curve("ITTC 1957, held below Re = 1e4", reynolds, [ittc57(r) for r in reynolds], "k-"),
        Curve("ours", [v * kSize[0] / kViscosity for v in kSpeeds], ours, "o")],
        log_x=True, log_y=True)


kCases = [
    Case("ittc57", "Drag and lift", "Friction of a flat plate by the ITTC 1957 line",
         "A plate of 4 × 0.01 × 1 m moves along itself, at Reynolds numbers from 250 to 4·10⁷, "
         "with the length of the friction line given and left out.",
         "½ρC_f S v² with C_f = 0.075/(log₁₀Re − 2)², Re = vL/ν, held below Re = 10⁴, and the "
         "area S of the sides along the motion. The tangential speed is the same everywhere, so "
         "that nothing is left to quadrature.", [kScene], measure),
]
