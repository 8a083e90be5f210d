"""Bodies with tabulated drag, and the program's law of drag summed over their panels."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from closed_forms import ittc57, thesis_viscous_coefficient
from meshes import Mesh

kSlices = 48  # Corners of every circle.
kViscosity = 1.0034e-6  # Of the scenes' water [m^2/s].


def as_read(vertices) -> np.ndarray:
    """The program reads mesh files in single precision."""
    return np.asarray(vertices, np.float32).astype(float)


def turned(profile: np.ndarray, slices: int = kSlices) -> Mesh:
    """Solid of revolution about x. Rows of the profile are (x, radius). It starts and ends on the
    axis and is nowhere else on it; x falls from start to end, so that normals point out."""
    angles = 2 * np.pi * np.arange(slices) / slices
    rings = [(x, r * np.cos(a), r * np.sin(a)) for x, r in profile[1:-1] for a in angles]
    vertices = [(profile[0, 0], 0, 0), *rings, (profile[-1, 0], 0, 0)]
    last = len(vertices) - 1
    faces = []
    for i in range(slices):
        j = (i + 1) % slices
        faces += [(0, 1 + i, 1 + j), (last, last - slices + j, last - slices + i)]
        for first in range(1, last - slices, slices):
            a, b, c, d = first + i, first + slices + i, first + slices + j, first + j
            faces += [(a, b, c), (a, c, d)]
    return as_read(vertices), np.array(faces)


def box(length: float, breadth: float, height: float, yaw: float = 0) -> Mesh:
    """Edges along x, y and z, turned about z."""
    signs = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    c, s = np.cos(yaw), np.sin(yaw)
    vertices = 0.5 * signs * (length, breadth, height) @ np.array([[c, s, 0], [-s, c, 0],
                                                                   [0, 0, 1]])
    faces = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7),
             (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]
    return as_read(vertices), np.array(faces)


def along_z(mesh: Mesh) -> Mesh:
    """A mesh about x, turned about z."""
    return mesh[0][:, [1, 2, 0]], mesh[1]


def cylinder(ratio: float) -> Mesh:
    return turned(np.array([[ratio / 2, 0], [ratio / 2, 0.5], [-ratio / 2, 0.5], [-ratio / 2, 0]]))


def ellipsoid(ratio: float) -> Mesh:
    angle = np.linspace(0, np.pi, kSlices + 1)
    profile = 0.5 * np.stack([ratio * np.cos(angle), np.sin(angle)], axis=1)
    profile[[0, -1], 1] = 0
    return turned(profile)


def hemisphere(round_first: bool) -> Mesh:
    angle = np.linspace(0, np.pi / 2, kSlices // 2 + 1)
    arc = 0.5 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    arc[0, 1] = 0
    profile = np.vstack([arc, [0, 0]])
    return turned(profile if round_first else profile[::-1] * (-1, 1))


def cone(half_angle: float, point_first: bool = True) -> Mesh:
    height = 0.5 / np.tan(np.radians(half_angle))
    profile = np.array([[height, 0], [0, 0.5], [0, 0]])
    return turned(profile if point_first else profile[::-1] * (-1, 1))


def streamlined(ratio: float, stations: int = 100) -> Mesh:
    """The thickness of a four-digit NACA foil with a closed tail, turned about its chord."""
    x = (1 - np.cos(np.linspace(0, np.pi, stations + 1))) / 2
    y = 0.2969 * np.sqrt(x) - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4
    y[[0, -1]] = 0
    return turned(np.stack([ratio * (1 - x), 0.5 * y / y.max()], axis=1))


@dataclass(frozen=True)
class Law:
    """Coefficients of drag; `thesis` says whose friction."""

    front: float
    back: float
    blunt: float
    thesis: bool = False

    def friction(self, speed: np.ndarray, length: float) -> np.ndarray:
        if self.thesis:
            return thesis_viscous_coefficient(speed)
        return ittc57(speed * length / kViscosity)


def slenderness(whole, finer_end, flat, law: Law):
    """The share k of the velocity that the pressure drag sees (hydro/loads/bluntness.h)."""
    if law.blunt == 0:
        return 1
    return np.minimum(1, np.minimum(whole / law.blunt,
                                    np.maximum(finer_end / law.blunt, np.cbrt(flat))))


kFlat = 0.95  # Square of the cosine of the angle to the axis from which on a face is flat.
kDefault = Law(0.71, 0.30, 0.30)
kThesis = Law(0.6316, 0.6316, 0, thesis=True)

Reference = Callable[[float, float], float]  # C_d at a speed [m/s] of a body of a diameter [m].


@dataclass(frozen=True)
class DragBody:
    """A closed mesh of diameter or edge 1 m that moves along +x, one of its axes."""

    name: str
    title: str
    mesh: Mesh
    reference: Reference
    slender: bool = False
    area_over_frontal: float = 1  # C_d is referred to the frontal area times this.

    @cached_property
    def area_vectors(self) -> np.ndarray:
        a, b, c = (self.mesh[0][self.mesh[1][:, i]] for i in range(3))
        return 0.5 * np.cross(b - a, c - a)

    @cached_property
    def areas(self) -> np.ndarray:
        return np.linalg.norm(self.area_vectors, axis=1)

    @property
    def length(self) -> float:
        """The longest side of the bounding box [m]."""
        return float(np.max(np.ptp(self.mesh[0], axis=0)))

    @property
    def reference_area(self) -> float:
        return float(self.area_over_frontal * np.sum(np.maximum(self.area_vectors[:, 0], 0)))

    def normal_integrals(self) -> tuple[float, float]:
        """Of |n_x|^3 over front and back, per area of reference."""
        part = self.area_vectors[:, 0]**3 / self.areas**2 / self.reference_area
        return float(np.sum(part[part > 0])), float(-np.sum(part[part < 0]))

    @cached_property
    def bluntness(self) -> tuple[float, float, float]:
        """Of the whole body, of its finer end, and the larger flat part of its ends."""
        along = self.area_vectors[:, 0]
        squares = (along / self.areas)**2
        ends = [np.abs(along) * (along < 0), np.abs(along) * (along > 0)]
        of_ends = [np.sum(end * squares) / np.sum(end) for end in ends]
        flat = [np.sum(end[squares > kFlat]) / np.sum(end) for end in ends]
        return float(np.mean(of_ends)), float(min(of_ends)), float(max(flat))

    def pressure(self, law: Law) -> float:
        """C_d of the pressure drag."""
        front, back = self.normal_integrals()
        return slenderness(*self.bluntness, law)**3 * (law.front * front + law.back * back)

    def friction(self, law: Law, speed: float, size: float = 1) -> float:
        """C_d of the viscous drag."""
        across = self.area_vectors[:, 0] / self.areas
        part = np.sqrt(np.maximum(0, 1 - across**2))
        c_v = law.friction(part * speed, self.length * size)
        return float(np.sum(self.areas * c_v * part**3) / self.reference_area)

    def drag(self, law: Law, speed: float, size: float = 1) -> float:
        """C_d, size in metres."""
        return self.pressure(law) + self.friction(law, speed, size)


def constant(value: float) -> Reference:
    return lambda speed, size: value


def turbulent_friction(reynolds: float) -> float:
    """The line of Prandtl and Schlichting."""
    return 0.455 / np.log10(reynolds)**2.58


def slender_body(name: str, title: str, mesh: Mesh, ratio: float) -> DragBody:
    """A body of revolution; C_d by Hoerner, Fluid-Dynamic Drag, 1965, ch. 6: friction of a plate
    with a form factor."""
    form = 1 + 1.5 * ratio**-1.5 + 7 * ratio**-3
    shape = DragBody(name, title, mesh, constant(0))
    wetted = np.sum(shape.areas) / shape.reference_area
    return DragBody(name, title, mesh, lambda speed, size: form * wetted * turbulent_friction(
        speed * ratio * size / kViscosity), slender=True)


def _bodies() -> list[DragBody]:
    """H: Hoerner, Fluid-Dynamic Drag, 1965, ch. 3. W: White, Fluid Mechanics, table 7.3, below the
    drag crisis. Both hold for Reynolds numbers of 1e4 and more."""
    plate = box(1, 1, 1e-4)  # Both sides take part: C_d is referred to one.
    plates = [DragBody(f"plate_{n}", f"plate 1:{n}", box(0.02, 1, n), constant(c_d))
              for n, c_d in ((1, 1.18), (5, 1.20), (10, 1.30))]  # W
    cones = [DragBody(f"cone_{half}", f"cone, half angle {half}°, point first", cone(half),
                      constant(c_d), slender=half == 10)
             for half, c_d in ((10, 0.30), (20, 0.40), (30, 0.55), (40, 0.65), (60, 0.80),
                               (75, 1.05))]  # W
    along = [DragBody(f"along_{i}", f"cylinder along, L/D {ratio:g}", cylinder(ratio),
                      constant(c_d), slender=ratio >= 4)
             for i, (ratio, c_d) in enumerate(((0.5, 1.15), (1, 0.90), (2, 0.85), (4, 0.87),
                                               (8, 0.99)))]  # W
    across = [DragBody(f"across_{ratio}", f"cylinder across, L/D {ratio}",
                       along_z(cylinder(ratio)), constant(c_d))
              for ratio, c_d in ((1, 0.64), (2, 0.68), (5, 0.74), (10, 0.82), (40, 0.98))]  # W
    return [
        DragBody("disc", "disc", cylinder(0.02), constant(1.17)),  # H
        *plates,
        DragBody("cube_face", "cube, face on", box(1, 1, 1), constant(1.05)),  # H
        DragBody("cube_edge", "cube, edge on", box(1, 1, 1, np.pi / 4), constant(0.80)),  # H
        *cones,
        DragBody("cone_base", "cone, half angle 30°, base first", cone(30, False),
                 constant(1.14)),  # H
        DragBody("hemisphere_round", "hemisphere, round side first", hemisphere(True),
                 constant(0.42)),  # H
        DragBody("hemisphere_flat", "hemisphere, flat side first", hemisphere(False),
                 constant(1.17)),  # H
        *along, *across,
        DragBody("ellipsoid_075", "ellipsoid, L/D 0.75", ellipsoid(0.75), constant(0.50)),  # W
        DragBody("sphere", "sphere", ellipsoid(1), constant(0.47)),  # W
        DragBody("ellipsoid_2", "ellipsoid, L/D 2", ellipsoid(2), constant(0.27)),  # W
        *[slender_body(f"ellipsoid_{n}", f"ellipsoid, L/D {n}", ellipsoid(n), n) for n in (4, 8)],
        *[slender_body(f"streamlined_{n}", f"streamlined body, L/D {n}", streamlined(n), n)
          for n in (4, 6, 10)],
        DragBody("plate_edge_on", "flat plate, edge on", plate,
                 lambda speed, size: 2 * turbulent_friction(speed * size / kViscosity),
                 slender=True, area_over_frontal=1e4),
    ]


kBodies = _bodies()
