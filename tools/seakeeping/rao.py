"""Measures response amplitude operators of the bodies of a scene: see tools/rao."""

from __future__ import annotations

import argparse
import csv
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from harmonics import Response, kWindow, response
from still_sea import Wave, sea_of

kRoot = Path(__file__).resolve().parents[2]
kProgram = os.environ.get("PLIMSOLL", str(kRoot / "build/plimsoll"))
kMotions = ("surge", "sway", "heave", "roll", "pitch", "yaw")
kTurns = kMotions[3:]
kSteady = 0.01  # Change of an operator from one third of a run to the next, below which it is steady:
kSmall = 0.1  # relative to the operator, or to this where the operator is smaller.
kPerPeriod = 40  # States that are logged in a period of the wave.
kInterrupted = 130


@dataclass(frozen=True)
class Row:
    """One body in one wave."""

    wave: Wave
    body: str
    responses: dict[str, Response]
    cycles: int

    def operator(self, name: str) -> complex:
        """The response amplitude operator: m/m, or rad over the slope k a of the wave."""
        scale = self.wave.amplitude * (self.wave.number if name in kTurns else 1)
        return self.responses[name].amplitude / scale

    @property
    def change(self) -> float:
        """The largest change of an operator, as kSteady has it."""
        sizes = {name: abs(self.operator(name)) for name in self.responses}
        return max(self.responses[name].change * size / max(size, kSmall)
                   for name, size in sizes.items())

    @property
    def steady(self) -> bool:
        return self.change <= kSteady


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tools/rao",
        description="Measures response amplitude operators: the first harmonic of each motion over "
                    "the wave's amplitude, turns over its slope k a, with the phase by which it "
                    "leads the crest over the body's mean place. Free oscillations are told apart. "
                    "Runs each wave until the last two thirds of the run agree to "
                    f"{100 * kSteady:g} %%. Prints a table and writes rao.csv and rao.png.")
    parser.add_argument("scene", type=Path)
    parser.add_argument("--periods", default="4:16:7", metavar="FIRST:LAST:COUNT",
                        help="wave periods [s], evenly spaced, or a list T1,T2,… [4:16:7]")
    height = parser.add_mutually_exclusive_group()
    height.add_argument("--amplitude", type=float, default=0.1, help="of the wave [m] [0.1]")
    height.add_argument("--slope", type=float,
                        help="k a of the wave, in place of its amplitude: alike for all periods")
    parser.add_argument("--heading", type=float, default=180,
                        help="direction in which the wave travels [deg]; 180: head sea for a bow "
                             "along +x [180]")
    parser.add_argument("--motions", nargs="+", choices=kMotions, metavar="MOTION",
                        default=["surge", "heave", "pitch"],
                        help=f"of {', '.join(kMotions)} [surge heave pitch]")
    parser.add_argument("--cycles", type=int, default=30, help="wave periods of a run [30]")
    parser.add_argument("--most-cycles", type=int, default=120,
                        help="a run that is not steady is repeated twice as long up to this [120]")
    parser.add_argument("--reference", type=Path,
                        help="CSV with a column period and columns as in rao.csv, to compare with")
    parser.add_argument("--set", action="append", default=[], metavar="KEY.PATH=VALUE",
                        help="override of the scene, as plimsoll run has it")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="runs at a time")
    parser.add_argument("--out", type=Path, help="folder for the results [out/rao/SCENE]")
    arguments = parser.parse_args()
    arguments.out = arguments.out or kRoot / "out/rao" / arguments.scene.stem
    try:
        arguments.periods = periods_of(arguments.periods)
    except ValueError:
        parser.error(f"--periods: {arguments.periods!r} is neither FIRST:LAST:COUNT nor T1,T2,…")
    if not all(number > 0 for number in (*arguments.periods, arguments.amplitude,
                                         1 if arguments.slope is None else arguments.slope)):
        parser.error("periods, amplitude and slope must be positive")
    return arguments


def periods_of(text: str) -> list[float]:
    if ":" in text:
        first, last, count = text.split(":")
        return [float(p) for p in np.linspace(float(first), float(last), int(count))]
    return [float(p) for p in text.split(",")]


def run_scene(arguments: argparse.Namespace, wave: Wave, cycles: int) -> Path:
    """Returns the folder of the run; raises the program's message if it fails."""
    folder = arguments.out / "runs" / f"T{wave.period:g}"
    train = {"amplitude": wave.amplitude, "period": wave.period, "heading_deg": arguments.heading}
    settings = {"water.surface": {"waves": [train]}, "duration": cycles * wave.period,
                "log.every": wave.period / kPerPeriod}
    options = [part for key, value in settings.items()
               for part in ("--set", f"{key}={json.dumps(value)}")]
    options += [part for setting in arguments.set for part in ("--set", setting)]
    command = [kProgram, "run", str(arguments.scene), "--no-render", "--quiet", "--out",
               str(folder), *options]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode != 0:
        raise RuntimeError(result.stderr.strip() or f"{' '.join(command)} failed")
    return folder


def turns_of(q: np.ndarray) -> np.ndarray:
    """Roll, pitch and yaw [rad] of quaternions w, x, y, z, yaw first."""
    w, x, y, z = q.T
    return np.unwrap(np.stack([np.arctan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
                               np.arcsin(np.clip(2 * (w * y - z * x), -1, 1)),
                               np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))]))


def motions_of(folder: Path) -> dict[str, tuple[np.ndarray, dict[str, np.ndarray]]]:
    """Of each body the times and its six motions."""
    with open(folder / "trajectory.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    motions = {}
    for body in dict.fromkeys(row["body"] for row in rows):
        of_body = [row for row in rows if row["body"] == body]
        numbers = {key: np.array([float(row[key]) for row in of_body])
                   for key in ("time", "x", "y", "z", "qw", "qx", "qy", "qz")}
        turns = turns_of(np.stack([numbers[key] for key in ("qw", "qx", "qy", "qz")], axis=1))
        series = dict(zip(kMotions, [numbers["x"], numbers["y"], numbers["z"], *turns]))
        motions[body] = (numbers["time"], series)
    return motions


def measure(arguments: argparse.Namespace, wave: Wave) -> list[Row]:
    """All bodies in one wave, in runs that grow until they are steady."""
    cycles = max(arguments.cycles, 3 * kWindow)
    while True:
        rows = []
        for body, (t, series) in motions_of(run_scene(arguments, wave, cycles)).items():
            advance = wave.advance(series["surge"], series["sway"])
            rows.append(Row(wave, body, {name: response(t, series[name], wave.omega, advance)
                                         for name in arguments.motions}, cycles))
        if all(row.steady for row in rows) or 2 * cycles > arguments.most_cycles:
            return rows
        cycles *= 2


def table_of(rows: list[Row]) -> list[dict]:
    table = []
    for row in rows:
        line = {"period": row.wave.period, "wavelength": 2 * np.pi / row.wave.number,
                "amplitude": row.wave.amplitude, "body": row.body}
        for name in row.responses:
            found = row.operator(name)
            line[name] = abs(found)
            line[f"{name}_phase_deg"] = float(np.degrees(np.angle(found)))
            line[f"{name}_drift"] = row.responses[name].drift
        line["change"] = row.change
        line["steady"] = int(row.steady)
        line["cycles"] = row.cycles
        table.append(line)
    return table


def print_table(arguments: argparse.Namespace, table: list[dict]) -> None:
    heads = [f"{name:>7} {'phase':>6}" for name in arguments.motions]
    print(f"{'period':>7} {'length':>7}  {'body':<12} {'  '.join(heads)}  steady")
    for line in table:
        cells = [f"{line[name]:7.3f} {line[f'{name}_phase_deg']:6.0f}" for name in arguments.motions]
        note = "yes" if line["steady"] else f"no, {100 * line['change']:.0f} % off"
        print(f"{line['period']:7.3g} {line['wavelength']:7.4g}  {line['body']:<12.12} "
              f"{'  '.join(cells)}  {note}")


def read_reference(file: Path) -> dict[str, np.ndarray]:
    with open(file, newline="") as stream:
        rows = list(csv.DictReader(stream))
    if not rows or "period" not in rows[0]:
        raise RuntimeError(f"{file}: there is no column 'period'")
    return {key: np.array([float(row[key]) for row in rows])
            for key in rows[0] if key == "period" or key.removesuffix("_phase_deg") in kMotions}


def print_differences(table: list[dict], reference: dict[str, np.ndarray]) -> None:
    """Between the periods of the reference it is taken as linear."""
    order = np.argsort(reference["period"])
    for name in kMotions:
        lines = [line for line in table if name in line and name in reference
                 and reference["period"].min() <= line["period"] <= reference["period"].max()]
        if lines:
            periods = np.array([line["period"] for line in lines])
            off = (np.array([line[name] for line in lines])
                   - np.interp(periods, reference["period"][order], reference[name][order]))
            worst = np.argmax(np.abs(off))
            print(f"{name} against the reference: {np.sqrt(np.mean(off**2)):.3f} root mean square, "
                  f"{off[worst]:+.3f} at {periods[worst]:g} s")


def plot(arguments: argparse.Namespace, table: list[dict], reference: dict | None) -> None:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    count = len(arguments.motions)
    figure, axes = plt.subplots(2, count, figsize=(3.8 * count, 5.2), sharex=True, squeeze=False,
                                gridspec_kw={"height_ratios": [2, 1]})
    for column, name in enumerate(arguments.motions):
        above, below = axes[0][column], axes[1][column]
        if reference and name in reference:
            above.plot(reference["period"], reference[name], "k--", linewidth=1, label="reference")
        if reference and f"{name}_phase_deg" in reference:
            below.plot(reference["period"], wrapped(reference[f"{name}_phase_deg"]), "k_")
        for body in dict.fromkeys(line["body"] for line in table):
            draw_body(above, below, name, [line for line in table if line["body"] == body], body)
        above.set_title(f"{name} [{'–' if name in kTurns else 'm/m'}]", fontsize=10)
        above.set_ylim(0, 1.08 * above.get_ylim()[1])
        below.set_ylim(-145, 235)
        below.set_yticks([-90, 0, 90, 180])
        below.set_xlabel("wave period [s]")
        for axis in (above, below):
            axis.grid(alpha=0.3)
        add_lengths(above, table)
    axes[0][0].set_ylabel("amplitude over a, turns over k a")
    axes[1][0].set_ylabel("lead of the crest [deg]")
    axes[0][0].legend(frameon=False, fontsize=8)
    height = (f"k a = {arguments.slope:g}" if arguments.slope else
              f"amplitude {arguments.amplitude:g} m")
    figure.suptitle(f"{arguments.scene.stem}: waves of {height}, heading {arguments.heading:g}°; "
                    "hollow: not steady", fontsize=10)
    figure.tight_layout()
    figure.savefig(arguments.out / "rao.png", dpi=130)


def wrapped(degrees: np.ndarray | float):
    """Into (-135, 225]: common leads, -90, 0, 90 and 180, are far from its ends."""
    return 225 - (225 - np.asarray(degrees)) % 360


def draw_body(above, below, name: str, lines: list[dict], body: str) -> None:
    lines = sorted(lines, key=lambda line: line["period"])
    drawn, = above.plot([line["period"] for line in lines], [line[name] for line in lines], "-",
                        linewidth=1.2, label=body)
    for line in lines:
        style = {"color": drawn.get_color(), "markersize": 4,
                 "markerfacecolor": drawn.get_color() if line["steady"] else "white"}
        above.plot(line["period"], line[name], "o", **style)
        if line[name] > kSteady:  # Smaller ones have a phase of no meaning.
            below.plot(line["period"], wrapped(line[f"{name}_phase_deg"]), "o", **style)


def add_lengths(axes, table: list[dict]) -> None:
    """The lengths of the waves at some of the periods, above the plot."""
    lengths = sorted({(line["period"], line["wavelength"]) for line in table})
    some = lengths[:: max(1, -(-len(lengths) // 6))]
    top = axes.secondary_xaxis("top")
    top.set_xticks([period for period, _ in some], [f"{length:.3g} m" for _, length in some],
                   fontsize=7, color="0.4")
    top.tick_params(length=2, color="0.4")


def main() -> int:
    arguments = parse_arguments()
    arguments.out.mkdir(parents=True, exist_ok=True)
    reference = read_reference(arguments.reference) if arguments.reference else None
    sea = sea_of(kProgram, arguments.scene, arguments.set)
    waves = [sea.wave(period, arguments.heading, arguments.amplitude, arguments.slope)
             for period in arguments.periods]
    rows: list[Row] = []
    with ThreadPoolExecutor(max(1, arguments.jobs)) as pool:
        for done, found in enumerate(pool.map(lambda wave: measure(arguments, wave), waves)):
            rows += found
            print(f"\r{done + 1} of {len(waves)} periods", end="", file=sys.stderr)
    print(file=sys.stderr)
    table = table_of(rows)
    print_table(arguments, table)
    if reference:
        print_differences(table, reference)
    with open(arguments.out / "rao.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, table[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(table)
    plot(arguments, table, reference)
    print(f"wrote {arguments.out}/rao.csv and rao.png")
    return 0 if all(line["steady"] for line in table) else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except RuntimeError as error:
        sys.exit(f"error: {error}")
    except KeyboardInterrupt:
        sys.exit(kInterrupted)
