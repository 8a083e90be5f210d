"""Plots as SVG, to stand in the page itself."""

from __future__ import annotations

import io
from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as pyplot  # noqa: E402  The backend is chosen first.

from case import Plot  # noqa: E402

kColors = ("#0b6e99", "#c8553d", "#4c8c4a", "#8a5a9e", "#b8860b", "#5a6b7b", "#a0468c")

pyplot.rcParams.update({
    "svg.fonttype": "none",       # Text stays text, in the page's font.
    "svg.hashsalt": "plimsoll",   # The same plot gives the same bytes.
    "font.family": "sans-serif", "font.size": 9, "axes.titlesize": 10, "axes.titleweight": "bold",
    "axes.titlelocation": "left", "axes.edgecolor": "#8a949e", "axes.linewidth": 0.8,
    "axes.labelcolor": "#37424d", "xtick.color": "#5a6672", "ytick.color": "#5a6672",
    "axes.grid": True, "grid.color": "#e3e8ec", "grid.linewidth": 0.8,
    "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False,
    "legend.fontsize": 8.5, "lines.linewidth": 1.5, "lines.markersize": 5,
})

# Of figures that are shown beside the text of a page.
kFigureStyle = {"svg.fonttype": "path", "font.size": 8, "axes.titlesize": 9,
                "lines.linewidth": 1.3, "lines.markersize": 4}


def save(figure, folder: Path, name: str) -> Path:
    """As SVG and as PNG; the latter's path."""
    figure.savefig(folder / f"{name}.svg", metadata={"Date": None})
    figure.savefig(folder / f"{name}.png", dpi=160)
    pyplot.close(figure)
    return folder / f"{name}.png"


def draw(plot: Plot) -> str:
    """The svg element."""
    text = drawn(plot, "svg", transparent=True).decode("utf-8")
    return text[text.index("<svg"):]


def drawn(plot: Plot, format_name: str, **options) -> bytes:
    """The file's bytes, in a format that matplotlib writes."""
    figure, axes = pyplot.subplots(figsize=(5.4, 3.3), layout="constrained")
    colors = iter(kColors * 2)
    for curve in plot.curves:
        color = {} if "k" in curve.style else {"color": next(colors)}
        axes.plot(curve.x, curve.y, curve.style, label=curve.label or None,
                  markerfacecolor="none", **color)
    axes.set(title=plot.title, xlabel=plot.x_label, ylabel=plot.y_label)
    if plot.log_x:
        axes.set_xscale("log")
    if plot.log_y:
        axes.set_yscale("log")
    if len(plot.curves) > 1:
        axes.legend()
    picture = io.BytesIO()
    date = {"metadata": {"Date": None}} if format_name == "svg" else {}
    figure.savefig(picture, format=format_name, **date, **options)
    pyplot.close(figure)
    return picture.getvalue()
