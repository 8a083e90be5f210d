"""The figures of tools/benchmark: cost of the loads against triangles, of a step against bodies."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.ticker import NullLocator

import plots
from benchmark import kBare, Findings

pyplot = plots.pyplot

kGuide = "#9aa5ae"
# Colour, marker and dash of a curve, and its words at its right end.
kLooks = {("half", "plain"): ("#7a858f", "s", "-", "plain sum"),
          ("half", "no_tree"): ("#c8553d", "D", (0, (4, 2)), "half, without the tree"),
          ("waves", ""): ("#4c8c4a", "^", "-", "half, in a wave"),
          kBare: ("#1d252c", "x", (0, (1, 1.2)), "bare loop"),
          ("half", "viscous"): ("#8a5a9e", "P", "-", "half, with viscous drag"),
          ("half", ""): ("#c8553d", "o", "-", "half immersed"),
          ("submerged", ""): ("#0b6e99", "v", "-", "submerged")}


def draw(found: Findings, folder: Path) -> list[Path]:
    """SVG and PNG of each; the latter's paths."""
    with pyplot.rc_context(plots.kFigureStyle):
        return [plots.save(_hydro_cost(found), folder, "hydro_cost"),
                plots.save(_bodies(found), folder, "bodies")]


def _title(figure, found: Findings, words: str) -> None:
    figure.suptitle(f"{words} – {found.machine['cpu']}, one thread", fontsize=9, x=0.01, ha="left")


def _hydro_cost(found: Findings):
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(8.6, 4.0), layout="constrained",
                                            width_ratios=(1.15, 1))
    bare = found.curve(*kBare)
    ends: dict[str, list] = {"left": [], "right": []}
    for kind, (color, marker, dash, words) in kLooks.items():
        curve = found.curve(*kind)
        count = np.array(list(curve))
        seconds = np.array(list(curve.values()))
        look = {"color": color, "marker": marker, "linestyle": dash}
        left.loglog(count, seconds * 1e6, **look)
        ends["left"].append((words, seconds[-1] * 1e6, color))
        if kind != ("half", "plain"):
            ratio = seconds / np.array([bare[n] for n in curve])
            right.loglog(count, ratio, **look)
            ends["right"].append((words, ratio[-1], color))
    count = np.array([min(bare), max(bare)])
    line = found.curve("half", "")[count[0]] * 1e6 * count / count[0]
    left.loglog(count, line, color=kGuide, linewidth=0.9, zorder=1)
    ends["left"].append(("∝ triangles (thesis, Fig. 15)", line[-1], "#5a6672"))
    left.set(title="One evaluation of the loads", xlabel="triangles", ylabel="time [µs]")
    right.set(title="Over the bare vectorised loop", xlabel="triangles",
              ylabel="time over that of the bare loop")
    for axes, labels, steps in ((left, ends["left"], (1,)), (right, ends["right"], (1, 2, 5))):
        _direct_labels(axes, count[1], labels)
        _ticks(axes, sorted(bare), steps)
    _title(figure, found, "Loads of the water on a sphere")
    return figure


def _direct_labels(axes, x: float, labels: list[tuple[str, float, str]]) -> None:
    """Words at the right of curves that end at (x, value), moved apart where they would overlap."""
    low, high = np.log10(axes.get_ylim())
    gap = 0.052 * (high - low)
    labels = sorted(labels, key=lambda label: label[1])
    places = np.log10([value for _, value, _ in labels])
    for _ in range(100):
        for i in range(1, len(places)):
            overlap = gap - (places[i] - places[i - 1])
            if overlap > 0:
                places[i - 1:i + 1] += (-overlap / 2, overlap / 2)
    for (words, value, color), place in zip(labels, places):
        axes.annotate(words, (x, value), xytext=(x * 1.35, 10**place), textcoords="data",
                      fontsize=7, color=color, va="center", annotation_clip=False,
                      arrowprops={"arrowstyle": "-", "color": color, "linewidth": 0.4,
                                  "shrinkA": 0, "shrinkB": 3})


def _ticks(axes, counts: list[int], steps: tuple[int, ...]) -> None:
    """Counts below, and at the left these steps of every decade that is shown."""
    low, high = axes.get_ylim()
    values = [step * 10.0**power for power in range(-3, 6) for step in steps]
    values = [value for value in values if low <= value <= high]
    axes.set_xticks(counts, [f"{count:,}" for count in counts])
    axes.set_yticks(values, [f"{value:,g}" for value in values])
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_minor_locator(NullLocator())


def _bodies(found: Findings):
    figure, axes = pyplot.subplots(figsize=(5.2, 3.2), layout="constrained")
    shown = ("apart", "in heaps of ten", "in one heap")
    for arrangement, color, marker in zip(shown, plots.kColors, "osD"):
        chosen = [step for step in found.steps if step.arrangement == arrangement]
        axes.loglog([step.bodies for step in chosen], [step.per_body for step in chosen],
                    color=color, marker=marker)
        axes.annotate(arrangement, (chosen[-1].bodies, chosen[-1].per_body), xytext=(6, 4),
                      textcoords="offset points", fontsize=7, color=color, annotation_clip=False)
    axes.set(xlabel="bodies", ylabel="time a step and body [µs]")
    low, high = axes.get_ylim()
    axes.set_ylim(low / 1.5, high * 1.5)
    _ticks(axes, [1, 10, 100, 1000], (1, 2, 5))
    _title(figure, found, "A step of crates afloat, 192 triangles each")
    return figure
