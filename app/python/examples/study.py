"""A parameter study: how deep a ball dives that is dropped, by its density and height.

A batch runs all combinations at once; they share the ball's hull and its added mass.

    tools/python app/python/examples/study.py [OUT]
"""

import sys
from pathlib import Path

import matplotlib
import numpy as np

import plimsoll as pl

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

SCENE = {
    "plimsoll": 1,
    "duration": 3,
    "step": 0.005,
    "water": {"density": 1000},
    "bodies": [{"name": "ball", "icosphere": {"radius": 0.15, "subdivisions": 3}, "density": 500,
                "position": [0, 0, 1]}],
}


def main(out: Path) -> None:
    densities = np.linspace(200, 900, 15)
    heights = np.array([0.5, 1.0, 2.0, 4.0])
    grid = np.array([(d, h) for h in heights for d in densities])
    batch = pl.Batch(SCENE, len(grid), vary={
        "bodies[ball].density": grid[:, 0],
        "bodies[ball].position": [[0, 0, h] for h in grid[:, 1]],
    })
    lowest = np.zeros(len(grid))
    while batch.time[0] < 3:
        batch.step()
        np.minimum(lowest, batch.position[:, 0, 2], out=lowest)
    assert not batch.errors

    figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
    for height, depths in zip(heights, -lowest.reshape(len(heights), -1)):
        axes.plot(densities, depths, label=f"dropped from {height:g} m")
    axes.set(xlabel="density [kg/m³]", ylabel="greatest depth of the centre [m]", ylim=(0, None))
    axes.legend()
    figure.savefig(out / "study.png", dpi=110)
    deepest = int(np.argmin(lowest))
    print(f"deepest: {-lowest[deepest]:.2f} m at {grid[deepest, 0]:.0f} kg/m³ from {grid[deepest, 1]:g} m")


if __name__ == "__main__":
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else "out/examples")
    folder.mkdir(parents=True, exist_ok=True)
    main(folder)
