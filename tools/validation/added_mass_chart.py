"""The figure of tools/benchmark --added-mass: time and memory against unknowns."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import plots

pyplot = plots.pyplot

kGuide = "#b9c2ca"
kDirect = 5000  # Triangles up to which all pairs of panels are stored.


def draw(found, machine: dict, folder: Path) -> None:
    """SVG and PNG."""
    with pyplot.rc_context(plots.kFigureStyle):
        figure, (left, right) = pyplot.subplots(1, 2, figsize=(8.2, 3.7), layout="constrained")
        for name, curve in _curves(found).items():
            unknowns = [m.unknowns for m in curve]
            label = f"{name} ({machine['blas']})" if name == kDense else name
            look = {"color": kLooks[name][0], "marker": kLooks[name][1], "label": label}
            left.loglog(unknowns, [m.seconds for m in curve], **look)
            right.loglog(unknowns, [m.bytes / 1e6 for m in curve], **look)
        _guides(left, found, [m.seconds for m in found], (1, 3))
        _guides(right, found, [m.bytes / 1e6 for m in found], (1, 2))
        left.set(title="Time", xlabel="unknowns", ylabel="[s]")
        right.set(title="Memory", xlabel="unknowns", ylabel="[MB]")
        left.set_ylim(top=10 * left.get_ylim()[1])  # Room for the legend.
        left.legend(loc="upper left", fontsize=7)
        figure.suptitle(f"Added mass of a sphere, six motions – {machine['cpu']}, "
                        f"{machine['processors']} processors", fontsize=9, x=0.01, ha="left")
        plots.save(figure, folder, "added_mass")


kQuadratic = "default, quadratic, up to 5,000 triangles"
kCompressed = "default, linear, compressed"
kPlain = "the thesis's: constant, collocation, LU"
kDense = "a dense LU alone"
kLooks = {kQuadratic: ("#0b6e99", "o"), kCompressed: ("#4c8c4a", "D"), kPlain: ("#c8553d", "s"),
          kDense: ("#7a858f", "x")}


def _curves(found) -> dict[str, list]:
    ours = [m for m in found if m.method == "galerkin"]
    curves = {kQuadratic: [m for m in ours if m.triangles <= kDirect],
              kCompressed: [m for m in ours if m.triangles > kDirect],
              kPlain: [m for m in found if m.method == "constant"],
              kDense: [m for m in found if m.method == "dense"]}
    return {name: curve for name, curve in curves.items() if curve}


def _guides(axes, found, values: list[float], powers: tuple[int, int]) -> None:
    """Lines of two powers of the unknowns: the low one through the last measurement of ours, the
    high one through the last of the plain method."""
    for power, method, dash in zip(powers, ("galerkin", "constant"), ((0, (4, 3)), (0, (1, 2)))):
        chosen = [(m.unknowns, value) for m, value in zip(found, values) if m.method == method]
        if not chosen:
            continue
        unknowns, value = chosen[-1]
        x = np.geomspace(unknowns / 30, unknowns * (1 if power == 1 else 3), 2)
        axes.loglog(x, value * (x / unknowns)**power, color=kGuide, linestyle=dash, linewidth=0.9,
                    zorder=1)
        axes.annotate(f"∝ N{'' if power == 1 else '²' if power == 2 else '³'}",
                      (x[-1], value * (x[-1] / unknowns)**power), xytext=(2, 2),
                      textcoords="offset points", fontsize=7, color="#5a6672")
