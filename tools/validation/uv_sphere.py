"""The polyhedron that a UV sphere is, spinning about z: its friction by quadrature over its own
panels, and its moment of inertia, without the program."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np


def gore(radius: float, slices: int, stacks: int) -> np.ndarray:
    """Triangles of one of the `slices` equal gores: (F, 3, 3). At the poles the first corner is
    the pole."""
    angles = np.linspace(0, np.pi, stacks + 1)
    half = np.pi / slices
    left, right = (np.stack([radius * np.sin(angles) * np.cos(half),
                             side * radius * np.sin(angles) * np.sin(half),
                             radius * np.cos(angles)], axis=1) for side in (-1, 1))
    faces = [(left[0], left[1], right[1]), (left[-1], right[-2], left[-2])]
    for i in range(1, stacks - 1):
        faces += [(left[i], left[i + 1], right[i + 1]), (left[i], right[i + 1], right[i])]
    return np.array(faces)


def quadrature_points(faces: np.ndarray, cells: int = 8, order: int = 6):
    """Points and weights on triangles, by a composite Gauss product rule whose rays leave the
    first corner: exact for |r| about it."""
    x, w = np.polynomial.legendre.leggauss(order)
    nodes = ((np.arange(cells)[:, None] + (1 + x) / 2) / cells).ravel()
    weights = np.tile(w / 2 / cells, cells)
    a, b, c = (faces[:, None, None, i] for i in range(3))
    ray, across = nodes[None, :, None, None], nodes[None, None, :, None]
    points = a + ray * (b - a + across * (c - b))
    twice_area = np.linalg.norm(np.cross(b - a, c - a), axis=-1)
    return points, twice_area * (nodes * weights)[None, :, None] * weights[None, None, :]


@dataclass(frozen=True)
class SpinningSphere:
    radius: float
    slices: int
    stacks: int

    @cached_property
    def _sums(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Tangential speeds per angular velocity u [m], ascending, and the running sums of u^3 and
        u^4 over the surface. On a panel the velocity is a rotation by omega n_z about the point
        where its plane meets the axis."""
        faces = gore(self.radius, self.slices, self.stacks)
        normals = np.cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 0])
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        pole_z = np.einsum("fi,fi->f", normals, faces[:, 0]) / normals[:, 2]
        points, weights = quadrature_points(faces)
        poles = np.stack([0 * pole_z, 0 * pole_z, pole_z], axis=1)[:, None, None]
        u = (np.abs(normals[:, 2])[:, None, None]
             * np.linalg.norm(points - poles, axis=-1)).ravel()
        order = np.argsort(u)
        u, area = u[order], self.slices * weights.ravel()[order]
        return u, *(np.concatenate([[0], np.cumsum(area * u**k)]) for k in (3, 4))

    def torque(self, omega: float, density: float, c_v: float) -> float:
        """-M for constant C_v."""
        return 0.5 * density * c_v * omega**2 * self._sums[1][-1]

    def torque_of_thesis_law(self, omega: float, density: float) -> float:
        """-M for C_v = 0.1 below 1 m/s, 0.2 - 0.1 v up to 2 m/s and none above."""
        u, third, fourth = self._sums
        slow, fast = np.searchsorted(u * abs(omega), (1, 2))
        between = 0.2 * (third[fast] - third[slow]) - 0.1 * abs(omega) * (fourth[fast]
                                                                         - fourth[slow])
        return 0.5 * density * omega**2 * (0.1 * third[slow] + between)

    def moment_of_inertia(self, density: float) -> float:
        """About z: the tetrahedra between the centre and the panels."""
        faces = gore(self.radius, self.slices, self.stacks)
        volumes = np.abs(np.linalg.det(faces)) / 6
        squares = np.sum(faces[..., :2]**2, axis=(1, 2)) + np.sum(faces[..., :2].sum(axis=1)**2,
                                                                  axis=1)
        return float(self.slices * density * np.sum(volumes * squares) / 20)
