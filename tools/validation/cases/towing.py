"""A sphere pulled along the surface, with and without lift (thesis, Fig. 13)."""

import numpy as np

from case import Case, Curve, Plot, Result, compare
from closed_forms import kGravity
from plimsoll import Plimsoll
from towed_sphere import Tow, steady_state

kScene = "validation/towed_sphere.yaml"


def measure(plimsoll: Plimsoll) -> Result:
    result = Result()
    curves, rises, exact_rises = [], [], []
    for lift, style in ((0.01, "-"), (0, "--")):
        tow = Tow(radius=1, mass=550 * 4 / 3 * np.pi, pull=10000, density=1000, gravity=kGravity,
                  c_p=0.6316, c_l=lift)
        speed, height = steady_state(tow)
        track = plimsoll.run_one(kScene, f"lift_{lift}", {"hydro.lift": lift})
        name = "with lift" if lift else "without lift"
        rises.append(track.position[-1, 2])
        exact_rises.append(height)
        result.rows += [
            compare(f"speed, {name}", "m/s", speed, track.velocity[-1, 0], 5e-3,
                    headline=bool(lift)),
            compare(f"height of the centre, {name}", "m", height, track.position[-1, 2], 5e-3,
                    scale=1)]
        curves.append(Curve(name, track.t, track.position[:, 2], style))
    result.rows.append(compare("rise by lift", "m", exact_rises[0] - exact_rises[1],
                               rises[0] - rises[1], 0.02, headline=True))
    result.plots.append(Plot("Height of a sphere pulled along", "time [s]",
                             "height of the centre [m]", curves))
    return result


kCases = [
    Case("towed_sphere", "Drag and lift", "A sphere pulled along, with and without lift",
         "Thesis, Fig. 13: a floating sphere of 550 kg/m³ is pulled by 10,000 N; the one that "
         "feels lift runs higher. Compared after 40 s, when both run steadily.",
         "Speed and height at which the integrals of drag and lift over the wet part of a smooth "
         "sphere balance the pull and the weight. The tolerance is the mesh's, 4,900 triangles.",
         [kScene], measure),
]
