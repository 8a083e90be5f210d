"""Bluff bodies with tabulated drag, and the closed forms of their drag by panels."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

kDiameter = 1.0  # Of every body, edge of the cubes [m].
kSlices = 96


@dataclass(frozen=True)
class BluffBody:
    """Its C_d is C_p,front * front + C_p,back * back, with the integrals of n_x^2 |n_x| over the
    panels that move into the water and out of it, per frontal area."""

    name: str
    title: str
    front: float
    back: float
    tabulated: float  # C_d of Hoerner, Fluid-Dynamic Drag, 1965.
    frontal_area: float  # [m^2]

    def drag_coefficient(self, front: float, back: float) -> float:
        return front * self.front + back * self.back


kCircle = np.pi / 4 * kDiameter**2
kSquare = kDiameter**2

kBodies = [
    BluffBody("sphere", "sphere", 1 / 2, 1 / 2, 0.47, kCircle),
    BluffBody("hemisphere_round", "hemisphere, round side first", 1 / 2, 1, 0.42, kCircle),
    BluffBody("hemisphere_flat", "hemisphere, flat side first", 1, 1 / 2, 1.17, kCircle),
    BluffBody("cone_point", "cone of 60°, point first", 1 / 4, 1, 0.50, kCircle),
    BluffBody("cone_base", "cone of 60°, base first", 1, 1 / 4, 1.14, kCircle),
    BluffBody("cube_face", "cube, face on", 1, 1, 1.05, kSquare),
    BluffBody("cube_edge", "cube, edge on", 1 / 2, 1 / 2, 0.80, np.sqrt(2) * kSquare),
    BluffBody("cylinder_across", "cylinder, L/D = 1, across", 2 / 3, 2 / 3, 0.68, kSquare),
    BluffBody("cylinder_1_along", "cylinder, L/D = 1, along", 1, 1, 0.91, kCircle),
    BluffBody("cylinder_2_along", "cylinder, L/D = 2, along", 1, 1, 0.85, kCircle),
    BluffBody("disc", "disc", 1, 1, 1.17, kCircle),
]


def hemisphere_profile(rings: int = kSlices // 2) -> np.ndarray:
    """Rows of (x, radius) from the pole at +x to the middle of the flat side."""
    angle = np.linspace(0, np.pi / 2, rings + 1)
    arc = 0.5 * kDiameter * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    arc[0, 1] = 0
    return np.vstack([arc, [arc[-1, 0], 0]])


def cone_profile() -> np.ndarray:
    """The same of a cone whose sides meet in 60° at +x."""
    height = 0.5 * kDiameter / np.tan(np.radians(30))
    return np.array([[height, 0], [0, 0.5 * kDiameter], [0, 0]])


def write_turned(path: Path, profile: np.ndarray, slices: int = kSlices) -> None:
    """OBJ [m] of a solid of revolution about x. The profile starts and ends on the axis and is
    nowhere else on it; x falls from start to end, so that normals point out."""
    angles = 2 * np.pi * np.arange(slices) / slices
    rings = [[(x, r * np.cos(a), r * np.sin(a)) for a in angles] for x, r in profile[1:-1]]
    vertices = [(profile[0, 0], 0, 0), *(p for ring in rings for p in ring), (profile[-1, 0], 0, 0)]
    last = len(vertices)
    faces = []
    for i in range(slices):
        j = (i + 1) % slices
        faces += [(1, 2 + i, 2 + j), (last, last - slices + j, last - slices + i)]
        for first in range(2, last - slices, slices):
            a, b, c, d = first + i, first + slices + i, first + slices + j, first + j
            faces += [(a, b, c), (a, c, d)]
    with open(path, "w", encoding="utf-8") as file:
        file.writelines("v {!r} {!r} {!r}\n".format(*map(float, p)) for p in vertices)
        file.writelines("f {} {} {}\n".format(*f) for f in faces)
