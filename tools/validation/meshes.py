"""Closed meshes that cases make for themselves: vertices (V, 3), triangles (F, 3), normals out."""

from __future__ import annotations

from pathlib import Path

import numpy as np

Mesh = tuple[np.ndarray, np.ndarray]


def write_obj(path: Path, mesh: Mesh) -> None:
    vertices, faces = mesh
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.writelines("v {!r} {!r} {!r}\n".format(*map(float, p)) for p in vertices)
        file.writelines("f {} {} {}\n".format(*(f + 1)) for f in faces)


def volume(mesh: Mesh) -> float:
    vertices, faces = mesh
    return float(np.linalg.det(vertices[faces]).sum() / 6)


def facing_out(vertices: np.ndarray, faces: np.ndarray) -> Mesh:
    """Of a solid that is seen whole from the origin."""
    inward = np.linalg.det(vertices[faces]) < 0
    faces = faces.copy()
    faces[inward] = faces[inward][:, ::-1]
    return vertices, faces


# Platonic solids ---------------------------------------------------------------------------------

def tetrahedron() -> Mesh:
    vertices = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)
    return facing_out(vertices, np.array([[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]))


def octahedron() -> Mesh:
    vertices = np.vstack([np.eye(3), -np.eye(3)])
    return facing_out(vertices, np.array([[a, b, c] for a in (0, 3) for b in (1, 4)
                                          for c in (2, 5)]))


def icosahedron() -> Mesh:
    golden = (1 + np.sqrt(5)) / 2
    vertices = np.array([np.roll((0, s, t * golden), turn) for turn in range(3)
                         for s in (-1, 1) for t in (-1, 1)])
    near = np.linalg.norm(vertices[:, None] - vertices, axis=2) < 2.1  # Edges are 2 long.
    faces = [(a, b, c) for a in range(12) for b in range(a) for c in range(b)
             if near[a, b] and near[b, c] and near[c, a]]
    return facing_out(vertices, np.array(faces))


def dodecahedron() -> Mesh:
    """Its corners are the middles of the icosahedron's faces; five triangles, a pentagon's three,
    meet no new corner."""
    points, triangles = icosahedron()
    vertices = points[triangles].mean(axis=1)
    faces = []
    for corner, axis in enumerate(points):
        ring = np.flatnonzero((triangles == corner).any(axis=1))
        side = vertices[ring[0]] - axis * (vertices[ring[0]] @ axis) / (axis @ axis)
        angle = np.arctan2(vertices[ring] @ np.cross(axis, side) / np.linalg.norm(axis),
                           vertices[ring] @ side)
        ring = ring[np.argsort(angle)]
        faces += [(ring[0], ring[i], ring[i + 1]) for i in (1, 2, 3)]
    return facing_out(vertices, np.array(faces))


# Round bodies ------------------------------------------------------------------------------------

def geodesic_sphere(frequency: int) -> Mesh:
    """The icosahedron with its edges cut into `frequency` parts, on the unit sphere: 20 frequency²
    triangles, 10 frequency² + 2 vertices."""
    points, triangles = icosahedron()
    known: dict[tuple, int] = {}
    vertices: list[np.ndarray] = []
    faces = []

    def vertex(corners: np.ndarray, weights: tuple[int, int, int]) -> int:
        key = tuple(sorted((int(c), w) for c, w in zip(corners, weights) if w))
        if key not in known:
            known[key] = len(vertices)
            vertices.append(np.asarray(weights) @ points[corners])
        return known[key]

    for corners in triangles:
        at = {(i, j): vertex(corners, (frequency - i - j, i, j))
              for i in range(frequency + 1) for j in range(frequency + 1 - i)}
        for i in range(frequency):
            for j in range(frequency - i):
                faces.append((at[i, j], at[i + 1, j], at[i, j + 1]))
                if i + j < frequency - 1:
                    faces.append((at[i + 1, j], at[i + 1, j + 1], at[i, j + 1]))
    on_sphere = np.array(vertices)
    on_sphere /= np.linalg.norm(on_sphere, axis=1)[:, None]
    return facing_out(on_sphere, np.array(faces))


def ellipsoid(semi_axes: tuple[float, float, float], frequency: int) -> Mesh:
    """The geodesic sphere, stretched."""
    vertices, faces = geodesic_sphere(frequency)
    return vertices * semi_axes, faces


def torus(radius: float, tube: float, around: int, across: int) -> Mesh:
    """About z, of 2 · around · across triangles, its vertices on the smooth torus."""
    u = 2 * np.pi * np.arange(around)[:, None] / around
    v = 2 * np.pi * np.arange(across)[None, :] / across
    rho = radius + tube * np.cos(v)
    vertices = np.stack([rho * np.cos(u), rho * np.sin(u), tube * np.sin(v) + 0 * u], axis=2)
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    at = lambda a, b: (a % around) * across + b % across
    first = np.stack([at(i, j), at(i + 1, j), at(i + 1, j + 1)], axis=2)
    second = np.stack([at(i, j), at(i + 1, j + 1), at(i, j + 1)], axis=2)
    return vertices.reshape(-1, 3), np.vstack([first.reshape(-1, 3), second.reshape(-1, 3)])


def torus_of_volume(radius: float, tube: float, around: int, across: int) -> Mesh:
    """The same, its tube thickened until the mesh has the volume of the smooth torus."""
    smooth, thick = 2 * np.pi**2 * radius * tube**2, tube
    for _ in range(6):  # The volume goes as the tube's square: one step, and the rest is round-off.
        thick *= np.sqrt(smooth / volume(torus(radius, thick, around, across)))
    return torus(radius, thick, around, across)
