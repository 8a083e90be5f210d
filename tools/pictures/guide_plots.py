"""Plots of what the tasks of scenes/GUIDE.md log, in one style that is read at half its size."""
from __future__ import annotations

import io
import json
import re

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from PIL import Image

from guide_frames import kBlue, kGray, kGreen, kInk, kPaper, kRed, kSize
from guide_work import Work

kPaleBlue, kPaleRed = "#7fc4dd", "#f0b9a9"  # Lines upon others that are nearly equal.
kDpi = 100

matplotlib.rcParams.update({
    "font.family": "DejaVu Sans", "font.size": 13.5, "axes.titlesize": 14, "axes.titlelocation": "left",
    "axes.titlecolor": kInk, "axes.edgecolor": "#8a949e", "axes.linewidth": 1.2,
    "xtick.color": kGray, "ytick.color": kGray, "xtick.major.width": 1.2, "ytick.major.width": 1.2,
    "axes.grid": True, "grid.color": "#dde3e8", "grid.linewidth": 1.2,
    "axes.spines.top": False, "axes.spines.right": False, "lines.linewidth": 3, "lines.markersize": 8,
    "figure.facecolor": kPaper, "axes.facecolor": kPaper,
    "axes.autolimit_mode": "data", "axes.xmargin": 0, "axes.ymargin": 0.08,
})


class Plot:
    """Axes with a quantity upward, whose name stands above, and another to the right."""

    def __init__(self, quantity: str, over: str = "time [s]"):
        self.figure = Figure((kSize[0] / kDpi, kSize[1] / kDpi), dpi=kDpi, layout="constrained")
        self.axes = self.figure.subplots()
        self.axes.set_title(quantity, pad=9)
        self.axes.set_xlabel(over, loc="right", color=kInk)
        self.axes.locator_params(nbins=5)

    def line(self, x, y, color: str, style: str = "-", **more) -> None:
        self.axes.plot(x, y, style, color=color, **more)

    def say(self, x: float, y: float, text: str, color: str, align: str = "left") -> None:
        """Names a line, at a place from (0, 0) to (1, 1)."""
        self.axes.text(x, y, text, color=color, ha=align, va="center", transform=self.axes.transAxes,
                       bbox={"facecolor": kPaper, "edgecolor": "none", "alpha": 0.75, "pad": 1.5})

    def image(self) -> Image.Image:
        file = io.BytesIO()
        self.figure.savefig(file, format="png", dpi=kDpi)
        return Image.open(file).convert("RGB")


def bars(quantity: str, values: dict[str, float], over: str = "") -> Image.Image:
    """Named lengths below each other, each with its number; `over` says what differs."""
    plot = Plot(quantity, over)
    axes = plot.axes
    axes.barh(list(values), list(values.values()), color=[kBlue, kRed][:len(values)], height=0.5)
    axes.set_xlim(0, 1.25 * max(values.values()))
    axes.set_ylim(len(values) - 0.4, -0.6)
    axes.grid(False)
    axes.set_xticks([])
    axes.spines["bottom"].set_visible(False)
    axes.tick_params(axis="y", length=0, labelcolor=kInk)
    for i, value in enumerate(values.values()):
        axes.text(value + 0.03 * max(values.values()), i, f"{value:.3g}", va="center", color=kInk)
    return plot.image()


def roll_deg(rows: dict) -> np.ndarray:
    w, x, y, z = (rows[name] for name in ("qw", "qx", "qy", "qz"))
    return np.degrees(np.arctan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)))


def yaw_deg(rows: dict) -> np.ndarray:
    w, x, y, z = (rows[name] for name in ("qw", "qx", "qy", "qz"))
    return np.degrees(np.unwrap(np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))))


def righting_arms(work: Work) -> Image.Image:
    rows = np.array([[float(word) for word in line.split()] for line in work.printed[0].splitlines()
                     if re.fullmatch(r"( +[-\d.]+){4}", line)])
    plot = Plot("righting arm GZ [m]", "heel [deg]")
    plot.axes.fill_between(rows[:, 0], rows[:, 1], color=kBlue, alpha=0.15, linewidth=0)
    plot.line(rows[:, 0], rows[:, 1], kBlue, "o-")
    plot.axes.set_ylim(0)
    return plot.image()


def densities(work: Work) -> Image.Image:
    plot = Plot("height of the cube [m]")
    for run, color in (("light", kBlue), ("heavy", kRed)):
        rows = work.table(f"out/{run}/trajectory.csv")
        plot.line(rows["time"], rows["z"], color)
    plot.axes.axhline(0, color=kGray, linewidth=1.5)
    plot.axes.set_ylim(-9, 5.5)
    plot.say(0.36, 0.93, "300 kg/m³", kBlue)
    plot.say(0.36, 0.07, "700 kg/m³", kRed)
    return plot.image()


def pile(work: Work) -> Image.Image:
    rows = work.table("out/pile/forces.csv")
    plot = Plot("force along the waves [N]")
    plot.line(rows["time"], rows["constraint_fx"], kRed)
    plot.line(rows["time"], rows["buoyancy_fx"], kBlue)
    plot.line(rows["time"], rows["diffraction_fx"], kPaleBlue, "--")
    plot.say(0.02, 0.93, "constraint", kRed)
    plot.say(0.02, 0.2, "waves", kBlue)
    plot.say(0.02, 0.07, "scattered waves", kBlue)
    return plot.image()


def calibrated(work: Work) -> Image.Image:
    work.run_scene("scenes/catamaran.yaml", out="out/fitted")
    plot = Plot("speed of the catamaran [m/s]")
    for run, color in (("fitted", kBlue), ("catamaran", kRed)):
        rows = work.table(f"out/{run}/trajectory.csv")
        plot.line(rows["time"], np.hypot(rows["vx"], rows["vy"]), color)
    plot.axes.set_ylim(0)
    plot.say(0.97, 0.86, "calibrated", kRed, "right")
    plot.say(0.97, 0.6, "fitted drag", kBlue, "right")
    return plot.image()


def spectrum(work: Work) -> Image.Image:
    rows = work.table("out/sea/probes.csv")
    plot = Plot("waves at the gauge [m]")
    plot.line(rows["time"], rows["elevation"], kBlue)
    return plot.image()


def gauge(work: Work) -> Image.Image:
    work.run_scene("tank.yaml", "duration=3.5", "log.every=0.02", "log.probes=[{name: gauge, wave: [0, 0]}]")
    given, rows = work.table("gauge.csv"), work.table("out/tank/probes.csv")
    plot = Plot("elevation at the gauge [m]")
    plot.line(rows["time"], rows["elevation"], kBlue)
    plot.line(given["time"], given["elevation"], kRed, "o", markersize=11, clip_on=False, zorder=3)
    plot.say(0.62, 0.93, "gauge.csv", kRed)
    plot.say(0.17, 0.93, "the run", kBlue)
    return plot.image()


def towed(work: Work) -> Image.Image:
    rows = work.table("out/tow/forces.csv")
    plot = Plot("towing force [N]")
    plot.line(rows["time"], rows["constraint_fx"], kRed)
    plot.axes.set_ylim(0, 10)
    return plot.image()


def resistance(work: Work) -> Image.Image:
    file = work.folder / "scenes/files/model_resistance.csv"
    given = np.loadtxt(file, delimiter=",", comments=("#", "s"))
    plot = Plot("resistance beyond friction [N]", "speed [m/s]")
    for body, color in (("michell", kRed), ("table", kBlue)):
        speed = work.table("out/towed_models/trajectory.csv", body=body)["vx"]
        force = -work.table("out/towed_models/forces.csv", body=body)["resistance_fx"]
        plot.line(speed, force, color)
        if body == "table":
            fastest = speed.max()
    known = given[given[:, 0] <= fastest]
    plot.line(known[:, 0], known[:, 1], kBlue, "o", zorder=3)
    plot.say(0.03, 0.93, "table", kBlue)
    plot.say(0.03, 0.8, "michell", kRed)
    return plot.image()


def autopilot(work: Work) -> Image.Image:
    rows = work.table("out/tug_and_barge/trajectory.csv", body="tug")
    rudder = work.table("out/tug_and_barge/machines.csv", machine="rudders[rudder]")
    plot = Plot("angle [deg]")
    plot.axes.axhline(90, color=kGray, linestyle="--", linewidth=2)
    plot.line(rudder["time"], rudder["angle_deg"], kRed)
    plot.line(rows["time"], yaw_deg(rows), kBlue)
    plot.say(0.97, 0.8, "target", kGray, "right")
    plot.say(0.25, 0.6, "heading", kBlue)
    plot.say(0.97, 0.24, "rudder", kRed, "right")
    return plot.image()


def tensions(work: Work) -> Image.Image:
    plot = Plot("tension of the chains [kN]")
    for line, color, style in (("lee", kBlue, "-"), ("port", kRed, "-"), ("starboard", kPaleRed, "--")):
        rows = work.table("out/moored_buoy/lines.csv", line=f"moorings[{line}]")
        plot.line(rows["time"], rows["tension"] / 1e3, color, style, linewidth=2.6)
    plot.axes.set_ylim(0)
    plot.say(0.03, 0.93, "port, starboard", kRed)
    plot.say(0.03, 0.16, "lee", kBlue)
    return plot.image()


def power(work: Work) -> Image.Image:
    rows = work.table("out/pto/joints.csv", joint="pto")
    told = json.loads((work.folder / "out/pto/summary.json").read_text(encoding="utf-8"))["joints"]
    plot = Plot("power of the damper [kW]")
    watts = np.abs(rows["effort"] * rows["speed"])
    mean = told["pto"]["power_mean"] / 1e3
    plot.line(rows["time"], watts / 1e3, kBlue, linewidth=2)
    plot.axes.axhline(mean, color=kRed, linewidth=3)
    plot.say(0.02, 0.92, f"mean {mean:.2f} kW", kRed)
    plot.axes.set_ylim(0, 1.3 * watts.max() / 1e3)
    return plot.image()


def decay(work: Work) -> Image.Image:
    rows = work.table("out/decay/trajectory.csv")
    time, roll = rows["time"], roll_deg(rows)
    size = np.abs(roll)
    peaks = [0, *(i for i in range(1, len(roll) - 1) if size[i - 1] < size[i] >= size[i + 1])]
    plot = Plot("roll [deg]")
    for side in (1, -1):
        plot.line(time[peaks], side * size[peaks], kGray, "--", linewidth=2)
    plot.line(time, roll, kBlue)
    plot.line(time[peaks], roll[peaks], kRed, "o", zorder=3, clip_on=False)
    return plot.image()


def operators(work: Work) -> Image.Image:
    plot = Plot("heave [m per m of wave]", "period [s]")
    for heading, name, color in (("90", "beam seas", kRed), ("135", "quartering", kGreen), ("180", "head seas", kBlue)):
        rows = work.table("rao.csv", heading_deg=heading)
        plot.line(rows["period"], rows["heave"], color, "o-", label=name)
    plot.axes.set_ylim(0)
    plot.axes.legend(loc="lower right", frameon=False, labelcolor="linecolor", handlelength=0)
    return plot.image()


def swept(work: Work) -> Image.Image:
    plot = Plot("lowest height of the cube [m]", "density [kg/m³]")
    for height, color in (("1", kBlue), ("2", kRed)):
        rows = work.table("out/s/sweep.csv", **{"bodies[cube].position[2]": height})
        plot.line(rows["bodies[cube].density"], rows["cube.z_min"], color, "o-", clip_on=False)
    plot.axes.set_xticks([300, 600, 900])
    plot.say(0.55, 0.93, "from 1 m", kBlue)
    plot.say(0.05, 0.15, "from 2 m", kRed)
    return plot.image()


def steps(work: Work) -> Image.Image:
    a, b = (work.table(f"out/{run}/trajectory.csv", body="float") for run in "ab")
    apart = np.sqrt(sum((a[axis] - b[axis]) ** 2 for axis in "xyz"))
    plot = Plot("float moved by half the step [mm]")
    plot.line(a["time"], 1e3 * apart, kBlue)
    plot.axes.axhline(10, color=kRed, linestyle="--", linewidth=2.5)
    plot.say(0.03, 0.82, "tolerance", kRed)
    plot.axes.set_ylim(0, 11)
    plot.axes.set_yticks([0, 5, 10])
    return plot.image()


def costs(work: Work) -> Image.Image:
    """The least cost of several checks each, for other programs run beside them."""
    def cost(*changes: str) -> float:
        told = [work.run("plimsoll", "check", "scenes/buoy_in_jonswap.yaml", *changes) for _ in range(9)]
        return min(float(re.search(r"([\d.]+) ms a step", text)[1]) for text in told)
    return bars("cost of a step [ms]", {"default": cost(), "1e-3": cost("--set", "hydro.wave_tolerance=1e-3")},
                "wave_tolerance")


def sizes(work: Work) -> Image.Image:
    plain = work.run_scene("scenes/buoy_in_jonswap.yaml", "log.every=0", out="out/plain")
    bytes_of = {"CSV": (plain / "trajectory.csv").stat().st_size,
                "HDF5": (work.folder / "out/buoy_in_jonswap/run.h5").stat().st_size}
    return bars("size of the log [kB]", {name: size / 1e3 for name, size in bytes_of.items()})


def resumed(work: Work) -> Image.Image:
    """Stops a second run after half the time of the first, and goes on with it."""
    scene = "scenes/two_barges_abreast.yaml"
    took = re.search(r"simulated in ([\d.]+) s", work.printed[0])[1]
    stopped = work.stop(scene, "out/stopped", float(took) / 2)
    work.run("plimsoll", "run", "--resume", "out/stopped", "--no-render")
    rows = work.table("out/stopped/trajectory.csv", body="upwave")
    plot = Plot("heave of a barge [m]")
    for part, color in ((rows["time"] <= stopped, kRed), (rows["time"] >= stopped, kBlue)):
        plot.line(rows["time"][part], rows["z"][part], color)
    plot.axes.axvline(stopped, color=kGray, linestyle="--", linewidth=2)
    plot.axes.set_ylim(-0.2, 0.8)
    plot.say(0.03, 0.9, "stopped", kRed)
    plot.say(0.97, 0.9, "resumed", kBlue, "right")
    return plot.image()


kMoreImu = """
import json
rows = []
for _ in range(700):
    sim.step()
    rows.append([sim.time, *sim.observe(["probes[imu].specific_x", "probes[imu].specific_y", "probes[imu].specific_z"])])
print(json.dumps(rows))
"""


def sensors(work: Work) -> Image.Image:
    rows = np.array(json.loads(work.continue_python(kMoreImu).splitlines()[-1]))
    plot = Plot("accelerometer [m/s²]")
    for column, name, color in ((1, "x", kBlue), (2, "y", kGreen), (3, "z", kRed)):
        plot.line(rows[:, 0], rows[:, column], color)
    plot.say(0.5, 0.75, "z", kRed)
    plot.say(0.5, 0.3, "x", kBlue)
    plot.say(0.58, 0.3, "y", kGreen)
    return plot.image()


kMoreBatch = """
import json
angles = [[angle] for angle in (-35, -25, -15, -5, 5, 15, 25, 35)]
rows = [env.step(angles)[0].tolist() for _ in range(38)]
print(json.dumps([[row[2] for row in of_all] for of_all in rows]))
"""


def batch(work: Work) -> Image.Image:
    rates = np.degrees(json.loads(work.continue_python(kMoreBatch).splitlines()[-1]))
    plot = Plot("yaw rate of 8 ships [deg/s]")
    for ship in range(rates.shape[1]):
        plot.line(np.arange(len(rates)) + 2, rates[:, ship], matplotlib.colormaps["coolwarm"](ship / 7), linewidth=2.5)
    plot.say(0.97, 0.92, "rudder 35°", kRed, "right")
    plot.say(0.97, 0.08, "rudder −35°", kBlue, "right")
    return plot.image()
