"""The three figures: error against run time, error against step, error against triangles."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import plots
from judgement import Judgement, judge, order_of, series_of, target_of
from studies import Finding, Row

pyplot = plots.pyplot

kColor = {"baseline": "#7a858f", "default": "#0b6e99", "tolerance": "#c8553d"}
kMarker = {"baseline": "s", "default": "o", "tolerance": "^"}
kName = {"baseline": "plain: loads once a step, ODE's step", "default": "default, fixed step",
         "tolerance": "default, with a tolerance"}
kStyle = {**plots.kFigureStyle, "lines.markersize": 3.6}
kFaint = "#b9c2ca"
kText = "#37424d"


def draw_all(findings: list[Finding], folder: Path) -> list[Path]:
    """SVG and PNG of the figures for which there is something to show."""
    figures = {"work_precision": _work_precision, "order": _order, "mesh": _mesh}
    written = []
    with pyplot.rc_context(kStyle):
        for name, draw in figures.items():
            figure = draw(findings)
            if figure is not None:
                written.append(plots.save(figure, folder, name))
    return written


def _panels(count: int, columns: int, y_label: str, x_label: str):
    rows = -(-count // columns)
    figure, grid = pyplot.subplots(rows, columns, figsize=(2.55 * columns, 2.35 * rows + 0.5),
                                   squeeze=False, sharey=True, layout="constrained")
    for axes in grid.flat[count:]:
        axes.set_visible(False)
    for axes in grid.flat[:count]:
        axes.set_xscale("log")
        axes.set_yscale("log")
    figure.supylabel(y_label, fontsize=8, color=kText)
    figure.supxlabel(x_label, fontsize=8, color=kText)
    return figure, list(grid.flat[:count])


def _limits(findings: list[Finding]) -> tuple[float, float]:
    """Of the error axis: whole decades around what is shown, no more than a decade above 1."""
    errors = [row.error_time for finding in findings for row in finding.rows
              if row.study == "time" and row.error_time]
    return 10**np.floor(np.log10(max(min(errors), 1e-11)) - 0.1), 10.0


def _legend(figure, methods: list[str]) -> None:
    handles = [pyplot.Line2D([], [], color=kColor[name], marker=kMarker[name], markersize=4,
                             label=kName[name]) for name in methods]
    top = 1 - 0.3 / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, 0, 1, top))
    figure.legend(handles=handles, loc="upper center", ncols=len(handles), frameon=False,
                  fontsize=8.5)


def _doubt(axes, finding: Finding, lowest: float) -> None:
    """Where errors are no larger than ten times the reference's own."""
    if finding.doubt > 0 and finding.floor > lowest:
        axes.axhspan(lowest, finding.floor, color="#eef1f4", zorder=0)


# Error against run time.

def _work_precision(findings: list[Finding]):
    shown = [f for f in findings if series_of(f, "baseline") and series_of(f, "default")]
    if not shown:
        return None
    figure, panels = _panels(len(shown), 4, "error of the trajectory",
                             "run time of the physics [s]")
    limits = _limits(shown)
    for axes, finding in zip(panels, shown):
        for name in kName:
            _work_curve(axes, series_of(finding, name), name)
        _goal(axes, finding)
        _doubt(axes, finding, limits[0])
        axes.set(title=finding.experiment.title, ylim=limits)
        _say(axes, judge(finding, "default"))
    _legend(figure, list(kName))
    return figure


def _work_curve(axes, rows: list[Row], name: str) -> None:
    if rows:
        axes.plot([row.seconds for row in rows], [max(row.error_time, 1e-16) for row in rows],
                  color=kColor[name], marker=kMarker[name], zorder=3)


def _goal(axes, finding: Finding) -> None:
    """The target: at the run time of the plain method's 1e-3 a hundredth (with impacts: a fifth)
    of its error, and at 1e-3 a tenth of its time."""
    compared = target_of(finding)
    if compared is None:
        return
    target, seconds = compared
    axes.axhline(target, color=kFaint, linewidth=0.7, linestyle=(0, (4, 3)), zorder=1)
    if finding.experiment.smooth:
        axes.plot([seconds / 10, seconds], [target, target / 100], color="#4c8c4a", linewidth=0.9,
                  linestyle=(0, (2, 1.5)), marker="*", markersize=5, zorder=2)
    else:
        axes.plot([seconds], [target / 5], color="#4c8c4a", marker="*", markersize=6, zorder=2,
                  linestyle="none")


def _say(axes, judgement: Judgement) -> None:
    lines = []
    if judgement.error_ratio:
        lines.append(f"{judgement.error_ratio} × smaller error")
    if judgement.speed_ratio:
        lines.append(f"{judgement.speed_ratio} × faster")
    axes.text(0.97, 0.97, "\n".join(lines), transform=axes.transAxes, ha="right", va="top",
              fontsize=7.5, color=kColor["default"])


# Error against step.

def _order(findings: list[Finding]):
    shown = [f for f in findings if series_of(f, "default")]
    if not shown:
        return None
    fullest = min((4, 5), key=lambda columns: -len(shown) % columns)
    figure, panels = _panels(len(shown), fullest, "error of the trajectory", "step [s]")
    limits = _limits(shown)
    for axes, finding in zip(panels, shown):
        for place, name in enumerate(("baseline", "default")):
            _order_curve(axes, finding, name, place)
        _slopes(axes, finding)
        _doubt(axes, finding, limits[0])
        axes.set(title=finding.experiment.title, ylim=limits)
        _step_ticks(axes, [15, 60, 240, 960, 3840])
    _legend(figure, ["baseline", "default"])
    return figure


def _order_curve(axes, finding: Finding, name: str, place: int) -> None:
    rows = series_of(finding, name)
    if not rows:
        return
    axes.plot([1 / row.rate for row in rows], [max(row.error_time, 1e-16) for row in rows],
              color=kColor[name], marker=kMarker[name], zorder=3)
    order = order_of(finding, name)
    text = "order –" if order is None else f"order {order:.2f}"
    axes.text(0.97, 0.04 + 0.09 * (1 - place), text, transform=axes.transAxes, ha="right",
              va="bottom", fontsize=7.5, color=kColor[name])


def _slopes(axes, finding: Finding) -> None:
    """Lines of first and second order through the largest step's error of the default."""
    rows = series_of(finding, "default")
    step = np.array([1 / row.rate for row in rows])
    for order, dash in ((1, (0, (1, 2))), (2, (0, (4, 3)))):
        axes.plot(step, rows[0].error_time * (step / step[0])**order, color=kFaint, linewidth=0.8,
                  linestyle=dash, zorder=1)


# Error against triangles.

def _mesh(findings: list[Finding]):
    meshed = [f for f in findings if any(row.error_mesh is not None for row in f.rows)]
    if not meshed:
        return None
    pairs = [f for f in meshed if f.experiment.all_pairs]
    figure, grid = pyplot.subplots(1, 1 + len(pairs), figsize=(3.4 * (1 + len(pairs)), 3.4),
                                   squeeze=False, layout="constrained")
    _mesh_errors(grid[0][0], meshed)
    for axes, finding in zip(grid[0][1:], pairs):
        _total_errors(axes, finding)
    return figure


def mesh_errors(finding: Finding) -> dict[int, float]:
    """By number of triangles."""
    return {row.triangles: row.error_mesh for row in finding.rows if row.error_mesh is not None}


def _mesh_errors(axes, findings: list[Finding]) -> None:
    for finding, color in zip(findings, plots.kColors):
        errors = mesh_errors(finding)
        cut = finding.experiment.mesh_kind == "cut"
        axes.loglog(errors.keys(), np.maximum(list(errors.values()), 1e-16), color=color,
                    marker="D" if cut else "o", linestyle="--" if cut else "-",
                    label=finding.experiment.title + (", clip" if cut else ""))
    count = np.array([80, 20480])
    axes.loglog(count, 0.5 / count, color=kFaint, linewidth=0.8, linestyle=(0, (4, 3)),
                label="1/triangles")
    axes.set(title="Error of the mesh and of the clip", xlabel="triangles",
             ylabel="error of the trajectory")
    low = axes.get_ylim()[0]
    axes.set_ylim(low / 300, None)  # Room for the legend.
    axes.legend(fontsize=6, loc="lower left", ncols=2, columnspacing=0.6, handlelength=2)


def _total_errors(axes, finding: Finding) -> None:
    """Against the exact shape: with a smaller step the mesh's own error is left."""
    rows = [row for row in finding.rows if row.study == "pairs" and not row.diverged]
    shades = pyplot.get_cmap("viridis")
    counts = sorted({row.triangles for row in rows})
    for i, count in enumerate(counts):
        color = shades(0.85 * i / max(1, len(counts) - 1))
        for method, dash in (("baseline", ":"), ("default", "-")):
            chosen = [row for row in rows if (row.triangles, row.method) == (count, method)]
            axes.loglog([1 / row.rate for row in chosen], [row.error_total for row in chosen],
                        dash, color=color, marker=kMarker[method], markersize=2.8,
                        label=kName[method] if i == 0 else None)
        axes.annotate(f"{count:,}", (1 / chosen[-1].rate, chosen[-1].error_total), xytext=(-4, 0),
                      textcoords="offset points", ha="right", va="center", fontsize=6.5,
                      color=color)
    axes.set(title=f"{finding.experiment.title}: triangles and step", xlabel="step [s]",
             ylabel="error against the exact shape",
             xlim=(0.25 / max(row.rate for row in rows), 1 / 12))
    _step_ticks(axes, [15, 60, 240, 960])
    low = axes.get_ylim()[0]
    axes.set_ylim(low / 10, None)  # Room for the legend.
    axes.legend(fontsize=6.5, loc="lower left")


def _step_ticks(axes, rates: list[int]) -> None:
    axes.set_xticks([1 / rate for rate in rates], [f"1/{rate}" for rate in rates])
    axes.minorticks_off()
