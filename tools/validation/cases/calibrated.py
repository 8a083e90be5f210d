"""Drag of bodies that are calibrated to tabulated values."""

import numpy as np

from case import Case, Result, compare_all
from plimsoll import Plimsoll
from shadow import read_triangles, shadow_area

kScene = "validation/calibrated_bodies.yaml"
kSpeed = 2.0
kBox = (2.0, 1.0, 0.5)

# As in the scene: C_d, and roll, pitch and yaw.
kDrag = {"box_12": (0.9, 1.1, 1.2), "box_768": (0.9, 1.1, 1.2), "teapot": (0.45, 0.6, 0.7),
         "hull": (0.1, 0.9, 1.3)}
kAttitude = {"box_12": (20, -35, 50), "box_768": (20, -35, 50), "teapot": (-110, 15, 200),
             "hull": (10, 25, -70)}
kTitles = {"box_12": "box of 12 triangles", "box_768": "box of 768 triangles",
           "teapot": "teapot", "hull": "Wigley's hull"}
# A box is exact. A raster of 2000 points a side is off by half a cell along the outline at most,
# which is 1e-3 of an area, and by far less because points fall in and out by turns.
kTolerance = {"box_12": 1e-12, "box_768": 1e-12, "teapot": 3e-4, "hull": 3e-4}


def rotation(roll: float, pitch: float, yaw: float) -> np.ndarray:
    """Rz(yaw) Ry(pitch) Rx(roll) of angles in degrees: body to world."""
    (cr, cp, cy), (sr, sp, sy) = (f(np.radians([roll, pitch, yaw])) for f in (np.cos, np.sin))
    turn_x = np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    turn_y = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
    turn_z = np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
    return turn_z @ turn_y @ turn_x


def frontal_areas(plimsoll: Plimsoll, name: str) -> list[float]:
    """Along the body's axes, computed without the program [m^2]."""
    if name.startswith("box"):
        return [kBox[1] * kBox[2], kBox[2] * kBox[0], kBox[0] * kBox[1]]
    mesh = {"teapot": "teapot_1k.obj", "hull": "wigley.obj"}[name]
    triangles = read_triangles(plimsoll.scenes / "meshes" / mesh)
    return [shadow_area(triangles, axis) for axis in range(3)]


def drags(plimsoll: Plimsoll, axis: int, sign: int, preset: str) -> dict[str, float]:
    """Against the motion along an axis of each body [N]."""
    ways = {name: sign * rotation(*kAttitude[name])[:, axis] for name in kDrag}
    bodies = plimsoll.probe(kScene, {"hydro.preset": preset, **{
        f"bodies[{name}].linear_velocity": list(kSpeed * way) for name, way in ways.items()}})
    return {name: -float(way @ bodies[name].pressure_drag.force) for name, way in ways.items()}


def measure(plimsoll: Plimsoll) -> Result:
    result = Result()
    areas = {name: frontal_areas(plimsoll, name) for name in kDrag}
    for preset in ("fitted", "thesis"):
        pairs = [[drags(plimsoll, axis, sign, preset) for sign in (1, -1)] for axis in range(3)]
        for name, title in kTitles.items():
            ours = [0.5 * (ahead[name] + astern[name])
                    / (500 * areas[name][axis] * kSpeed**2 * kDrag[name][axis])
                    for axis, (ahead, astern) in enumerate(pairs)]
            result.rows.append(compare_all(
                f"drag over the tabulated one, worst axis, {title}, {preset}", "–", np.ones(3),
                ours, kTolerance[name], scale=1,
                kind="exact" if name.startswith("box") else "raster",
                headline=(name, preset) == ("teapot", "fitted")))
    return result


kCases = [
    Case("calibrate", "Drag and lift", "Calibrated bodies have the tabulated drag",
         "A box of 12 and of 768 triangles, a teapot and Wigley's hull, each turned anyhow, move "
         "along each of their axes, ahead and astern; the mean of both directions is compared, "
         "with the default coefficients and with those of the thesis.",
         "½ρC_d S v² with the C_d of the scene and the area S of the body's shadow: for the boxes "
         "the product of two edges, for the others counted here on a raster of 2000 × 2000 "
         "points.", [kScene], measure),
]
