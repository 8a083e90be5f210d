"""The area of the shadow that a mesh throws, by counting the points of a raster under it."""

from __future__ import annotations

from pathlib import Path

import numpy as np


def read_triangles(path: Path) -> np.ndarray:
    """Corners of the triangles of an OBJ: (F, 3, 3)."""
    vertices, faces = [], []
    for line in path.read_text(encoding="utf-8").splitlines():
        kind, *words = line.split() or [""]
        if kind == "v":
            vertices.append([float(word) for word in words[:3]])
        elif kind == "f":
            faces.append([int(word.split("/")[0]) - 1 for word in words])
    return np.array(vertices)[np.array(faces)]


def shadow_area(triangles: np.ndarray, axis: int, points: int = 2000) -> float:
    """Of the union of the triangles along an axis. The raster has `points` cells along each side
    of the bounding box; the error is below half a cell along the outline."""
    plane = np.delete(triangles, axis, axis=2)
    low = plane.min(axis=(0, 1))
    cell = (plane.max(axis=(0, 1)) - low) / points
    covered = np.zeros((points, points), bool)
    for corners in (plane - low) / cell - 0.5:  # Points of the raster are at whole numbers.
        _cover(covered, corners)
    return float(np.count_nonzero(covered) * cell[0] * cell[1])


def _cover(covered: np.ndarray, corners: np.ndarray) -> None:
    """Marks the points inside a triangle, edges included."""
    first = np.maximum(np.ceil(corners.min(axis=0)), 0).astype(int)
    last = np.floor(corners.max(axis=0)).astype(int) + 1
    block = covered[first[0]:last[0], first[1]:last[1]]
    x, y = np.ogrid[first[0]:first[0] + block.shape[0], first[1]:first[1] + block.shape[1]]
    sides = []
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        sides.append((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]))
    block |= ((sides[0] >= 0) & (sides[1] >= 0) & (sides[2] >= 0)
              | (sides[0] <= 0) & (sides[1] <= 0) & (sides[2] <= 0))
