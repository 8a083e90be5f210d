"""Drops the teapot, draws it on its way and plots how deep it goes.

    tools/python app/python/examples/drop_teapot.py [OUT]
"""

import sys
from pathlib import Path

import matplotlib
import numpy as np

import plimsoll as pl

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

SCENES = Path(__file__).resolve().parents[3] / "scenes"


def main(out: Path) -> None:
    sim = pl.Simulation(pl.Scene.load(SCENES / "teapot_drop.yaml"))
    pot = sim.index("teapot")
    times, heights, submerged, pictures = [], [], [], []
    while sim.time < 3:
        if sim.steps % 36 == 0 and len(pictures) < 5:
            pictures.append((sim.time, sim.render(size=(480, 360))))
        times.append(sim.time)
        heights.append(sim.position[pot, 2])
        submerged.append(sim.forces("teapot")["displaced_volume"] * 1e3)
        sim.step()

    figure, axes = plt.subplot_mosaic([list("01234"), ["z"] * 5, ["v"] * 5], figsize=(11, 7),
                                      height_ratios=[1.3, 1, 1], layout="constrained")
    for i, (time, picture) in enumerate(pictures):
        axes[str(i)].imshow(picture)
        axes[str(i)].set_title(f"{time:.1f} s")
        axes[str(i)].axis("off")
    axes["z"].plot(times, heights)
    axes["z"].axhline(0, color="steelblue", lw=0.8)
    axes["z"].set_ylabel("centre of mass z [m]")
    axes["v"].plot(times, submerged)
    axes["v"].set(xlabel="time [s]", ylabel="displaced [l]")
    figure.savefig(out / "drop_teapot.png", dpi=100)

    lowest = int(np.argmin(heights))
    print(f"lowest {heights[lowest]:.3f} m at {times[lowest]:.2f} s")


if __name__ == "__main__":
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else "out/examples")
    folder.mkdir(parents=True, exist_ok=True)
    main(folder)
