"""A smooth sphere pulled level along the surface: the steady state by quadrature."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from closed_forms import cap_volume, thesis_viscous_coefficient


@dataclass(frozen=True)
class Tow:
    radius: float
    mass: float
    pull: float  # N
    density: float
    gravity: float
    c_p: float
    c_l: float


kNodes, kWeights = np.polynomial.legendre.leggauss(100)


def _wet_grid(tow: Tow, center_z: float):
    """Normals and area elements over the wet part n_z < -center_z / R, by Gauss–Legendre."""
    x, weights = kNodes, kWeights
    top = np.clip(-center_z / tow.radius, -1, 1)
    n_z = (-1 + top) / 2 + (top + 1) / 2 * x
    phi = np.pi / 4 * (1 + x)  # A quarter; the flow's two planes of symmetry give the rest.
    n_x = np.sqrt(1 - n_z**2)[:, None] * np.cos(phi)[None, :]
    area = 4 * tow.radius**2 * np.outer(weights * (top + 1) / 2, weights * np.pi / 4)
    return n_x, np.broadcast_to(n_z[:, None], n_x.shape), area


def resistance(tow: Tow, center_z: float, speed: float) -> float:
    """-F_x: pressure drag and viscous drag with the thesis's C_v."""
    n_x, _, area = _wet_grid(tow, center_z)
    tangential = speed * np.sqrt(1 - n_x**2)
    viscous = thesis_viscous_coefficient(tangential) * tangential * speed * (1 - n_x**2)
    return float(0.5 * tow.density
                 * np.sum(area * (tow.c_p * speed**2 * np.abs(n_x)**3 + viscous)))


def lift(tow: Tow, center_z: float, speed: float) -> float:
    """F_z."""
    n_x, n_z, area = _wet_grid(tow, center_z)
    return float(-0.5 * tow.density * tow.c_l * speed**2 * np.sum(area * (1 - n_x**2) * n_z))


def steady_speed(tow: Tow, center_z: float) -> float:
    """At which the resistance takes up the pull. The resistance over v^2 hardly depends on v, so
    the iteration gains two digits a round."""
    speed = 1.0
    for _ in range(12):
        speed *= np.sqrt(tow.pull / resistance(tow, center_z, speed))
    return float(speed)


def steady_state(tow: Tow) -> tuple[float, float]:
    """Speed, and height of the centre above the water: Newton's method with the stiffness of the
    sphere's largest waterplane."""
    z = 0.0
    for _ in range(30):
        speed = steady_speed(tow, z)
        buoyancy = tow.density * tow.gravity * cap_volume(tow.radius, tow.radius - z)
        excess = buoyancy + lift(tow, z, speed) - tow.mass * tow.gravity
        z += excess / (tow.density * tow.gravity * np.pi * tow.radius**2)
    return steady_speed(tow, z), float(z)
