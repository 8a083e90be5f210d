"""A sphere pulled along the surface, with and without lift (thesis, Fig. 13)."""

import numpy as np

from case import Case, Curve, Plot, Result
from closed_forms import kGravity
from convergence import mesh_rows
from plimsoll import Plimsoll
from towed_sphere import Tow, steady_state

kScene = "validation/towed_sphere.yaml"


kCounts = (24, 48, 96)  # Slices and stacks.


def steady(plimsoll: Plimsoll, lift: float, count: int):
    """The run, at whose end the sphere runs steadily."""
    return plimsoll.run_one(kScene, f"lift_{lift}_{count}", {
        "hydro.lift": lift, "bodies[0].sphere.slices": count, "bodies[0].sphere.stacks": count})


def measure(plimsoll: Plimsoll) -> Result:
    result = Result()
    curves, rises, exact_rises = [], [], []
    for lift, style in ((0.01, "-"), (0, "--")):
        tow = Tow(radius=1, mass=550 * 4 / 3 * np.pi, pull=10000, density=1000, gravity=kGravity,
                  c_p=0.6316, c_l=lift)
        speed, height = steady_state(tow)
        tracks = [steady(plimsoll, lift, count) for count in kCounts]
        name = "with lift" if lift else "without lift"
        rises.append(np.array([track.position[-1, 2] for track in tracks]))
        exact_rises.append(height)
        result.rows += mesh_rows(f"speed, {name}", "m/s", speed,
                                 [track.velocity[-1, 0] for track in tracks], "18,240 triangles",
                                 headline=bool(lift))
        result.rows += mesh_rows(f"height of the centre, {name}", "m", height, rises[-1],
                                 "18,240 triangles")
        curves.append(Curve(name, tracks[-1].t, tracks[-1].position[:, 2], style))
    finest, _, limit = mesh_rows("rise by lift", "m", exact_rises[0] - exact_rises[1],
                                 rises[0] - rises[1], "18,240 triangles", headline=True)
    result.rows += [finest, limit]  # Its order is that of the heights, of which it is a difference.
    result.plots.append(Plot("Height of a sphere pulled along", "time [s]",
                             "height of the centre [m]", curves))
    return result


kCases = [
    Case("towed_sphere", "Drag and lift", "A sphere pulled along, with and without lift",
         "Thesis, Fig. 13: a floating sphere of 550 kg/m³ is pulled by 10,000 N; the one that "
         "feels lift runs higher. Compared after 40 s, when both run steadily.",
         "Speed and height at which the integrals of drag and lift over the wet part of a smooth "
         "sphere balance the pull and the weight, on three meshes: their error vanishes with the "
         "square of the panels' size. (The mesh's mass is that of its volume.)",
         [kScene], measure),
]
