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

kRoot = Path(__file__).resolve().parents[2]
kMotions = ("surge", "sway", "heave", "roll", "pitch", "yaw")
kTurns = kMotions[3:]
kSteady = 0.01  # Change of the amplitude between two windows below which it is steady.
kPerPeriod = 40  # States that are logged in a period of the wave.
kInterrupted = 130


@dataclass(frozen=True)
class Row:
    """One body in one wave."""

    period: float  # s
    body: str
    responses: dict[str, Response]
    place: tuple[float, float]  # Mean place in the second half of the run [m].
    cycles: int

    @property
    def steady(self) -> bool:
        """Motions of less than a thousandth of the largest are noise."""
        largest = max(abs(r.amplitude) for r in self.responses.values())
        return all(r.change <= kSteady for r in self.responses.values()
                   if abs(r.amplitude) > 1e-3 * largest)


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tools/rao",
        description="Measures response amplitude operators: the first harmonic of each motion over "
                    "the wave's amplitude, turns over its slope k a, with the phase by which it "
                    "leads the crest over the body's mean place. Runs each wave until two windows of "
                    f"{kWindow} periods agree to {100 * kSteady:g} %%. Prints a table and writes "
                    "rao.csv and rao.png.")
    parser.add_argument("scene", type=Path)
    parser.add_argument("--periods", default="4:16:7", metavar="FIRST:LAST:COUNT",
                        help="wave periods [s], evenly spaced, or a list T1,T2,… [4:16:7]")
    parser.add_argument("--amplitude", type=float, default=0.1, help="of the wave [m] [0.1]")
    parser.add_argument("--heading", type=float, default=180,
                        help="direction in which the wave travels [deg]; 180: head sea for a bow "
                             "along +x [180]")
    parser.add_argument("--depth", type=float, default=np.inf,
                        help="water.depth of the scene [m], for slopes and phases [deep]")
    parser.add_argument("--motions", nargs="+", choices=kMotions, metavar="MOTION",
                        default=["surge", "heave", "pitch"],
                        help=f"of {', '.join(kMotions)} [surge heave pitch]")
    parser.add_argument("--cycles", type=int, default=25, help="wave periods of a run [25]")
    parser.add_argument("--most-cycles", type=int, default=100,
                        help="a run that is not steady is repeated twice as long up to this [100]")
    parser.add_argument("--undamped", action="store_true",
                        help="the scene has no damping: one free oscillation is fitted, too")
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
    if not all(period > 0 for period in arguments.periods) or not arguments.amplitude > 0:
        parser.error("periods and amplitude must be positive")
    return arguments


def periods_of(text: str) -> list[float]:
    if ":" in text:
        first, last, count = text.split(":")
        return [float(p) for p in np.linspace(float(first), float(last), int(count))]
    return [float(p) for p in text.split(",")]


def run_scene(arguments: argparse.Namespace, period: float, cycles: int) -> Path:
    """Returns the folder of the run; raises the program's message if it fails."""
    folder = arguments.out / "runs" / f"T{period:g}"
    wave = {"amplitude": arguments.amplitude, "period": period, "heading_deg": arguments.heading}
    settings = {"water.surface": {"waves": [wave]}, "duration": cycles * period,
                "log.every": period / kPerPeriod}
    options = [part for key, value in settings.items()
               for part in ("--set", f"{key}={json.dumps(value)}")]
    options += [part for setting in arguments.set for part in ("--set", setting)]
    command = [os.environ.get("PLIMSOLL", str(kRoot / "build/plimsoll")), "run",
               str(arguments.scene), "--no-render", "--quiet", "--out", str(folder), *options]
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


def measure(arguments: argparse.Namespace, period: float) -> list[Row]:
    """All bodies in the wave of one period, in runs that grow until they are steady."""
    cycles = max(arguments.cycles, 2 * kWindow + 2)
    while True:
        motions = motions_of(run_scene(arguments, period, cycles))
        omega = 2 * np.pi / period
        rows = [Row(period, body,
                    {name: response(t, series[name], omega, not arguments.undamped)
                     for name in arguments.motions},
                    tuple(series[name][t > t[-1] / 2].mean() for name in ("surge", "sway")),
                    cycles)
                for body, (t, series) in motions.items()]
        if all(row.steady for row in rows) or 2 * cycles > arguments.most_cycles:
            return rows
        cycles *= 2


def wave_number(omega: float, depth: float) -> float:
    """Of ω² = g k tanh kh, by Newton's method."""
    deep = omega**2 / 9.80665
    if not deep * depth < 20:
        return deep
    kh = np.sqrt(deep * depth) if deep * depth < 1 else deep * depth
    for _ in range(50):
        tanh = np.tanh(kh)
        kh -= (kh * tanh - deep * depth) / (tanh + kh * (1 - tanh**2))
    return kh / depth


def operator(arguments: argparse.Namespace, name: str, row: Row) -> complex:
    """The response amplitude operator: m/m, or rad over the slope k a of the wave."""
    k = wave_number(2 * np.pi / row.period, arguments.depth)
    heading = np.radians(arguments.heading)
    phase = k * (np.cos(heading) * row.place[0] + np.sin(heading) * row.place[1])
    scale = arguments.amplitude * (k if name in kTurns else 1)
    return row.responses[name].amplitude * np.exp(1j * phase) / scale


def table_of(arguments: argparse.Namespace, rows: list[Row]) -> list[dict]:
    table = []
    for row in rows:
        line = {"period": row.period, "body": row.body}
        for name in row.responses:
            found = operator(arguments, name, row)
            line[name] = abs(found)
            line[f"{name}_phase_deg"] = float(np.degrees(np.angle(found)))
        line["change"] = max(one.change for one in row.responses.values())
        line["steady"] = int(row.steady)
        line["cycles"] = row.cycles
        table.append(line)
    return table


def print_table(arguments: argparse.Namespace, table: list[dict]) -> None:
    heads = [f"{name:>7} {'phase':>6}" for name in arguments.motions]
    print(f"{'period':>7}  {'body':<12} {'  '.join(heads)}  steady")
    for line in table:
        cells = [f"{line[name]:7.3f} {line[f'{name}_phase_deg']:6.0f}" for name in arguments.motions]
        note = "yes" if line["steady"] else f"no, {100 * line['change']:.0f} % off"
        print(f"{line['period']:7.3g}  {line['body']:<12.12} {'  '.join(cells)}  {note}")


def read_reference(file: Path) -> dict[str, np.ndarray]:
    with open(file, newline="") as stream:
        rows = list(csv.DictReader(stream))
    if not rows or "period" not in rows[0]:
        raise RuntimeError(f"{file}: there is no column 'period'")
    return {key: np.array([float(row[key]) for row in rows])
            for key in rows[0] if key in ("period", *kMotions)}


def plot(arguments: argparse.Namespace, table: list[dict], reference: dict | None) -> None:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    count = len(arguments.motions)
    figure, axes = plt.subplots(2, count, figsize=(3.6 * count, 5), sharex=True, squeeze=False,
                                gridspec_kw={"height_ratios": [2, 1]})
    for column, name in enumerate(arguments.motions):
        above, below = axes[0][column], axes[1][column]
        for body in dict.fromkeys(line["body"] for line in table):
            lines = [line for line in table if line["body"] == body]
            periods = [line["period"] for line in lines]
            above.plot(periods, [line[name] for line in lines], "o-", markersize=4, label=body)
            below.plot(periods, [line[f"{name}_phase_deg"] for line in lines], "o", markersize=4)
        if reference and name in reference:
            above.plot(reference["period"], reference[name], "k--", linewidth=1, label="reference")
        above.set_title(name)
        above.set_ylim(0, 1.08 * above.get_ylim()[1])
        below.set_ylim(-190, 190)
        below.set_yticks([-180, -90, 0, 90, 180])
        below.set_xlabel("period [s]")
        for axis in (above, below):
            axis.grid(alpha=0.3)
    axes[0][0].set_ylabel("amplitude over a, turns over ka")
    axes[1][0].set_ylabel("lead [deg]")
    axes[0][0].legend(frameon=False, fontsize=8)
    figure.suptitle(f"{arguments.scene.stem}: waves of {arguments.amplitude:g} m, heading "
                    f"{arguments.heading:g}°", fontsize=10)
    figure.tight_layout()
    figure.savefig(arguments.out / "rao.png", dpi=130)


def main() -> int:
    arguments = parse_arguments()
    arguments.out.mkdir(parents=True, exist_ok=True)
    reference = read_reference(arguments.reference) if arguments.reference else None
    rows: list[Row] = []
    with ThreadPoolExecutor(max(1, arguments.jobs)) as pool:
        for done, found in enumerate(pool.map(lambda p: measure(arguments, p), arguments.periods)):
            rows += found
            print(f"\r{done + 1} of {len(arguments.periods)} periods", end="", file=sys.stderr)
    print(file=sys.stderr)
    table = table_of(arguments, rows)
    print_table(arguments, table)
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
