"""Heave of a floating sphere in regular waves: the response amplitude operator, by a batch.

Linear theory has the response |X| / |C − ω²(M + A) − iωB| with the sphere's own radiation and
diffraction (pl.radiation); the simulations have it with all loads in the time domain.

    tools/python app/python/examples/waves.py [OUT]
"""

import math
import sys
from pathlib import Path

import matplotlib
import numpy as np

import plimsoll as pl

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

RADIUS, AMPLITUDE, G, RHO = 1.0, 0.02, 9.80665, 1000.0

SCENE = {
    "plimsoll": 1,
    "duration": 60,
    "step": 0.02,
    "water": {"density": RHO, "surface": {"waves": [{"amplitude": AMPLITUDE, "period": 3}], "ramp": 5}},
    "bodies": [{
        "name": "float",
        "icosphere": {"radius": RADIUS, "subdivisions": 3},
        "density": RHO / 2,
        "lock": ["x", "y", "roll", "pitch", "yaw"],
        "hydro": {"radiation": "auto", "pressure_drag": False, "viscous_drag": False, "lift": False},
    }],
}


def simulated(periods: np.ndarray) -> np.ndarray:
    """Heave amplitudes over the waves' amplitude, from the first harmonic of the last periods."""
    batch = pl.Batch(SCENE, len(periods), vary={"water.surface.waves[0].period": periods})
    heave = []
    while batch.time[0] < 60:
        batch.step()
        heave.append(batch.position[:, 0, 2].copy())
    time = np.arange(1, len(heave) + 1) * batch.step_length
    response = []
    for z, period in zip(np.transpose(heave), periods):
        last = time > 60 - 6 * period
        phase = 2 * np.pi / period * time[last]
        basis = np.stack([np.cos(phase), np.sin(phase), np.ones_like(phase)], axis=1)
        c, s, _ = np.linalg.lstsq(basis, z[last], rcond=None)[0]
        response.append(math.hypot(c, s) / AMPLITUDE)
    return np.array(response)


def linear(periods: np.ndarray) -> np.ndarray:
    """Heave amplitudes over the waves' amplitude by linear theory."""
    mesh = pl.Mesh.icosphere(RADIUS, 3)
    omega = np.sort(2 * np.pi / periods)
    found = pl.radiation(mesh, height=0.0, frequencies=list(omega), density=RHO, headings=4)
    exciting = (found["froude_krylov"] + found["diffraction"])[:, 0, 2]
    mass = RHO / 2 * mesh.volume
    stiffness = RHO * G * math.pi * RADIUS**2
    heave = np.abs(exciting / (stiffness - omega**2 * (mass + found["added_mass"][:, 2, 2])
                               - 1j * omega * found["damping"][:, 2, 2]))
    return np.interp(2 * np.pi / periods, omega, heave)


def main(out: Path) -> None:
    periods = np.array([1.7, 1.9, 2.1, 2.4, 2.8, 3.5, 4.5, 6.0])
    measured = simulated(periods)
    fine = np.linspace(periods[0], periods[-1], 40)

    figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
    axes.plot(fine, linear(fine), color="0.6", label="linear theory")
    axes.plot(periods, measured, "o", label="simulated")
    axes.set(xlabel="period of the waves [s]", ylabel="heave over amplitude [–]", ylim=(0, None))
    axes.legend()
    figure.savefig(out / "waves.png", dpi=110)

    error = np.max(np.abs(measured / linear(periods) - 1))
    for period, response in zip(periods, measured):
        print(f"{period:4.1f} s: {response:.3f}")
    print(f"largest departure from linear theory: {100 * error:.1f} %")


if __name__ == "__main__":
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else "out/examples")
    folder.mkdir(parents=True, exist_ok=True)
    main(folder)
