"""Meshes of Wigley's hull, as fine as asked for."""

from pathlib import Path


def write_wigley(path: Path, stations: int, rows: int, length: float = 10, breadth: float = 1,
                 draft: float = 0.625, freeboard: float = 0.375) -> None:
    """OBJ [m]: y = B/2 (1 - (2x/L)^2) (1 - (z/T)^2) below z = 0 in rows of equal height, upright
    sides from there to a flat deck. Keel and stems, where the breadth is zero, are shared by both
    sides. Normals point out."""
    vertices: list[tuple[float, float, float]] = []
    index: dict[tuple[int, int, int], int] = {}

    def vertex(i: int, j: int, side: int) -> int:
        x = length * (i / stations - 0.5)
        z = draft * (j / rows - 1) if j <= rows else freeboard
        y = 0.5 * breadth * (1 - (2 * i / stations - 1)**2) * (1 - (min(z, 0) / draft)**2)
        key = (i, j, 0 if y == 0 else side)
        if key not in index:
            vertices.append((x, side * y if y else 0.0, z))
            index[key] = len(vertices)
        return index[key]

    faces: list[tuple[int, int, int]] = []

    def quad(i: int, a: int, b: int, c: int, d: int) -> None:
        """Cut from the corner that is lower and farther from midships, so that where keel meets
        stem the sides do not share a triangle."""
        cut = ((a, b, c), (a, c, d)) if i < stations / 2 else ((b, c, d), (b, d, a))
        faces.extend(f for f in cut if len(set(f)) == 3)

    for i in range(stations):
        for j in range(rows + 1):
            corners = ((0, 0), (1, 0), (1, 1), (0, 1))
            quad(i, *(vertex(i + p, j + q, -1) for p, q in corners))
            a, b, c, d = (vertex(i + p, j + q, 1) for p, q in corners)
            quad(stations - 1 - i, b, a, d, c)
        quad(i, *(vertex(i + p, rows + 1, side) for p, side in ((0, -1), (1, -1), (1, 1), (0, 1))))
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in vertices)
        file.writelines(f"f {a} {b} {c}\n" for a, b, c in faces)
