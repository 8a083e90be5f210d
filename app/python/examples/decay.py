"""Compares the decay of a floating sphere with experiments.

The sphere is let go above its rest; the waves that it sends out take its energy. Kramer et al.
(Energies 14, 2021, 269) measured the first period and the first trough.

    tools/python app/python/examples/decay.py [OUT]
"""

import sys
from pathlib import Path

import matplotlib
import numpy as np

import plimsoll as pl

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

SCENES = Path(__file__).resolve().parents[3] / "scenes"
MEASURED = {30: (0.7869, 24.93), 90: (0.8093, 75.73), 150: (0.8671, 128.62)}  # mm: s, mm


def main(out: Path) -> None:
    figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
    print("released   period [s]          first trough [mm]")
    for release, (period, trough) in MEASURED.items():
        scene = pl.Scene.load(SCENES / "sphere_decay.yaml", set={
            "bodies[sphere].position": [0, 0, release / 1000],
            # Flow that turns within a diameter hardly separates: drag would take what waves take.
            "hydro": {"pressure_drag": False, "viscous_drag": False, "lift": False},
        })
        sim = pl.Simulation(scene)
        heights = [sim.position[0, 2]]
        while sim.time < 3:
            sim.step()
            heights.append(sim.position[0, 2])
        # The rest is as far below the start as the sphere was lifted.
        z = release + 1000 * (np.array(heights) - heights[0])
        time = np.arange(len(heights)) * scene.step
        at = np.flatnonzero(z[:-1] * z[1:] < 0)[:2]
        first, second = time[at] + scene.step * z[at] / (z[at] - z[at + 1])
        found = 2 * (second - first), -z.min()
        axes.plot(time, z / release, label=f"released at {release} mm")
        axes.plot(time[np.argmin(z)], -trough / release, "kx")
        print(f"{release:4} mm    {found[0]:.4f} ({100 * (found[0] / period - 1):+.1f} %)     "
              f"{found[1]:.2f} ({100 * (found[1] / trough - 1):+.1f} %)")
    axes.plot([], [], "kx", label="measured first trough")
    axes.set(xlabel="time [s]", ylabel="height over release [–]")
    axes.legend()
    figure.savefig(out / "decay.png", dpi=110)


if __name__ == "__main__":
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else "out/examples")
    folder.mkdir(parents=True, exist_ok=True)
    main(folder)
