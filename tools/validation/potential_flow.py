"""Linear radiation and diffraction of a floating body at rest in water of constant depth, by
constant panels.

The reference for motions in waves shares nothing with the program. Time goes as e^{-iωt}, waves
travel along +x, a crest is over the origin at time 0. Needs SciPy.

Green's function of deep water [N85], with X = kR and Y = -k(z + z'):
  G = 1/r + 1/r' + k (F + 2πi e^{-Y} J0(X)),
  F = -π e^{-Y} (H0(X) + Y0(X)) - 2 ∫_0^Y e^{t-Y} / sqrt(X² + t²) dt.

In water of the depth h, k above is K = ω²/g, and G has the image 1/r'' in the bottom and the
integral of `of_depth` in addition, along a path below the poles.

[N85] Newman. Algorithms for the free-surface Green function. J. Eng. Math. 19 (1985) 57-67.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import RectBivariateSpline
from scipy.optimize import brentq
from scipy.special import j0, j1, jv, struve, y0, y1

from floating_bodies import Inertia

kSurge, kHeave, kPitch = range(3)
kParities = ((-1, 1), (1, 1), (-1, 1))  # Of the three potentials in x and in y.
kPoints, kWeights = np.polynomial.legendre.leggauss(40)
kFarthest = 36.0  # e^-36 is round-off.


@dataclass(frozen=True)
class Panels:
    """A quarter, x > 0 and y > 0, of a wetted hull that mirrors itself in x and y: flat
    quadrilaterals (N, 4, 3) whose corners turn counter-clockwise as the water sees them [m]."""

    corners: np.ndarray

    @property
    def area_vectors(self) -> np.ndarray:
        a, b, c, d = np.moveaxis(self.corners, 1, 0)
        return np.cross(c - a, d - b) / 2

    @property
    def areas(self) -> np.ndarray:
        return np.linalg.norm(self.area_vectors, axis=1)

    @property
    def normals(self) -> np.ndarray:
        return self.area_vectors / self.areas[:, None]

    @property
    def centroids(self) -> np.ndarray:
        a, b, c, d = np.moveaxis(self.corners, 1, 0)
        first = np.linalg.norm(np.cross(b - a, c - a), axis=1)[:, None]
        second = np.linalg.norm(np.cross(c - a, d - a), axis=1)[:, None]
        return (first * (a + b + c) + second * (a + c + d)) / (3 * (first + second))

    def mirrored(self, x: int, y: int, z: int = 1) -> Panels:
        """The image under x → ±x and so on; the corners turn as before."""
        corners = self.corners * (x, y, z)
        return Panels(corners if x * y * z > 0 else corners[:, ::-1])

    def points(self) -> tuple[np.ndarray, np.ndarray]:
        """Four points a panel (N, 4, 3) and their shares of its area (N, 4), by Gauss' rule on the
        bilinear patch."""
        a, b, c, d = np.moveaxis(self.corners, 1, 0)
        points, weights = [], []
        for s in (-3**-0.5, 3**-0.5):
            for t in (-3**-0.5, 3**-0.5):
                points.append(((1 - s) * (1 - t) * a + (1 + s) * (1 - t) * b
                               + (1 + s) * (1 + t) * c + (1 - s) * (1 + t) * d) / 4)
                along = (1 - t) * (b - a) + (1 + t) * (c - d)
                across = (1 - s) * (d - a) + (1 + s) * (c - b)
                weights.append(np.linalg.norm(np.cross(along, across), axis=1) / 16)
        return np.stack(points, axis=1), np.stack(weights, axis=1)


@dataclass(frozen=True)
class Coefficients:
    """In surge, heave and pitch about a point; of the wave of unit amplitude."""

    added_mass: np.ndarray
    damping: np.ndarray
    excitation: np.ndarray  # Complex.
    froude_krylov: np.ndarray  # Its part from the pressure of the undisturbed wave.


def integrals_of_source(points: np.ndarray, panels: Panels) -> tuple[np.ndarray, np.ndarray]:
    """∫ 1/r dS and ∫ ∂(1/r)/∂n dS of panels at points, (P, N) each, in closed form."""
    normals, corners = panels.normals, panels.corners
    height = np.einsum("pnk,nk->pn", points[:, None] - corners[None, :, 0], normals)
    to = corners[None] - points[:, None, None]  # (P, N, 4, 3)
    far = np.linalg.norm(to, axis=3)
    source = np.zeros_like(height)
    for i in range(4):
        j = (i + 1) % 4
        edge = corners[:, j] - corners[:, i]
        length = np.linalg.norm(edge, axis=1)
        sound = length > 0
        along = edge / np.where(sound, length, 1)[:, None]
        outward = np.cross(along, normals)
        inside = np.einsum("pnk,nk->pn", to[:, :, i], outward)
        sum_ = far[:, :, i] + far[:, :, j]
        near = np.maximum(sum_ - length, 1e-12 * sum_)
        source += np.where(sound, inside * np.log((sum_ + length) / near), 0)
    angle = sum(_solid_angle(to[:, :, corner], far[:, :, corner])
                for corner in ((0, 1, 2), (0, 2, 3)))
    angle = np.where(np.abs(height) < 1e-9 * np.sqrt(panels.areas), 0, np.abs(angle))
    return source - np.abs(height) * angle, np.sign(height) * angle


def _solid_angle(to: np.ndarray, far: np.ndarray) -> np.ndarray:
    """Of triangles, signed [van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983)]."""
    a, b, c = np.moveaxis(to, 2, 0)
    la, lb, lc = np.moveaxis(far, 2, 0)
    triple = np.einsum("pnk,pnk->pn", a, np.cross(b, c))
    dot = lambda u, v: np.einsum("pnk,pnk->pn", u, v)
    return 2 * np.arctan2(triple, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb)


def wave_part(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """F + 2πi e^{-Y} J0(X), and its derivative by X."""
    x = np.maximum(x, 1e-6)
    least = np.arcsinh(np.maximum(y - kFarthest, 0) / x)
    span = np.arcsinh(y / x) - least
    first, second = np.zeros_like(x), np.zeros_like(x)
    for point, weight in zip(kPoints, kWeights):
        u = least + span * (point + 1) / 2
        value = weight / 2 * span * np.exp(x * np.sinh(u) - y)
        first += value
        second += value / np.cosh(u)**2
    decay = np.exp(-y)
    real = -np.pi * decay * (struve(0, x) + y0(x)) - 2 * first
    slope = np.pi * decay * (struve(1, x) + y1(x) - 2 / np.pi) + 2 / x * second
    return real + 2j * np.pi * decay * j0(x), slope - 2j * np.pi * decay * j1(x)


def wave_number(k: float, depth: float) -> float:
    """Of waves with ω²/g = k."""
    return brentq(lambda q: q * np.tanh(q * depth) - k, k / 2, k + 10 / depth, xtol=1e-15 * k)


@dataclass(frozen=True)
class FiniteDepth:
    """What the depth adds to G of deep water, less 1/r'': splines of ∫ f J0(μR) dμ over the range
    of a hull."""

    depth: float
    parts: tuple  # Of |z - z'| and of z + z' + 2h: the real and the imaginary part of each.

    def at(self, distance: np.ndarray, z: np.ndarray, height: np.ndarray):
        """The sum, and its slopes by the distance and by the source's height."""
        total = []
        apart = height - z
        for along, across in ((0, 0), (1, 0), (0, 1)):
            sums = 0
            for part, v, slope in zip(self.parts, (np.abs(apart), z + height + 2 * self.depth),
                                      (np.sign(apart), 1)):
                real, imaginary = (s.ev(distance, v, dx=along, dy=across) for s in part)
                sums = sums + (slope if across else 1) * (real + 1j * imaginary)
            total.append(sums)
        return total


def of_depth(k: float, depth: float, reach: float, draft: float) -> FiniteDepth:
    pole = wave_number(k, depth)
    dip = min(pole / 2, 1.5 / reach)
    corners = [0, pole - 1j * dip, 2 * pole, max(2 * pole, 30 / (2 * depth - draft))]
    mu, weights = [], []
    for a, b in zip(corners, corners[1:]):
        count = 4 + int(abs(b - a) * max(depth, reach, 1 / dip) / 10)
        for i in range(count):
            start, step = a + (b - a) * i / count, (b - a) / count
            mu.append(start + step * (kPoints + 1) / 2)
            weights.append(step * kWeights / 2)
    mu, weights = np.concatenate(mu), np.concatenate(weights)
    fade = np.exp(-2 * mu * depth)
    ratio = (mu + k) / (mu - k - (mu + k) * fade)
    low = lambda v: ratio * (np.exp(-mu * (2 * depth - v)) + np.exp(-mu * (2 * depth + v)))
    high = lambda v: ratio * (np.exp(-mu * (2 * depth + v))
                              + (mu + k) / (mu - k) * np.exp(-mu * (4 * depth - v)))
    distances = np.linspace(0, reach, 30 + int(10 * reach * max(1 / depth, pole)))
    waves = jv(0, mu[None] * distances[:, None]) * weights
    parts = []
    for integrand, start, end in ((low, 0, draft), (high, 2 * (depth - draft), 2 * depth)):
        places = np.linspace(start, end, 24)
        values = waves @ np.stack([integrand(v) for v in places], axis=1)
        parts.append(tuple(RectBivariateSpline(distances, places, part, kx=5, ky=5)
                           for part in (values.real, values.imag)))
    return FiniteDepth(depth, tuple(parts))


def influence(at: np.ndarray, of: Panels, k: float,
              finite: FiniteDepth | None = None) -> tuple[np.ndarray, np.ndarray]:
    """∫ G dS and ∫ ∂G/∂n dS of panels at points, (P, N) each."""
    image = of.mirrored(1, 1, -1)
    source, dipole = integrals_of_source(at, of)
    source_above, dipole_above = integrals_of_source(at, image)
    points, weights = of.points()
    away = at[:, None, None, :2] - points[None, ..., :2]
    distance = np.maximum(np.linalg.norm(away, axis=3), 1e-6 / k)
    value, slope = wave_part(k * distance,
                             -k * (at[:, None, None, 2] + points[None, ..., 2]))
    normal = of.normals
    outward = -np.einsum("pnqk,nk->pnq", away, normal[:, :2]) / distance
    # ∂/∂Y of the whole is minus the whole, less 2/ρ: 2 k n_z / r', which has a closed form.
    rise = normal[None, :, None, 2] * value
    wave = k * np.einsum("pnq,nq->pn", value, weights)
    waving = k**2 * np.einsum("pnq,nq->pn", slope * outward + rise, weights)
    if finite:
        below = Panels(image.corners - (0, 0, 2 * finite.depth))
        more, dipole_below = integrals_of_source(at, below)
        value, along, up = finite.at(distance, at[:, None, None, 2], points[None, ..., 2])
        wave = wave + more + np.einsum("pnq,nq->pn", value, weights)
        waving = waving + dipole_below + np.einsum(
            "pnq,nq->pn", along * outward + normal[None, :, None, 2] * up, weights)
    return (source + source_above + wave,
            dipole + dipole_above + waving + 2 * k * normal[:, 2] * source_above)


def potentials(panels: Panels, modes: np.ndarray, k: float,
               finite: FiniteDepth | None = None) -> np.ndarray:
    """On the panels, of motions with unit velocity whose normal parts are `modes` (N, 3):
    2π φ = ∫ (φ ∂G/∂n − G ∂φ/∂n) dS."""
    at = panels.centroids
    images = [(x, y) for x in (1, -1) for y in (1, -1)]
    parts = [influence(at, panels.mirrored(x, y), k, finite) for x, y in images]
    result = np.empty(modes.shape, complex)
    for mode, (px, py) in enumerate(kParities):
        signs = [(px if x < 0 else 1) * (py if y < 0 else 1) for x, y in images]
        source, dipole = (sum(sign * part[i] for sign, part in zip(signs, parts)) for i in (0, 1))
        matrix = 2 * np.pi * np.eye(len(at)) - dipole
        result[:, mode] = np.linalg.solve(matrix, -source @ modes[:, mode])
    return result


def solve(panels: Panels, k: float, centre: float, density: float,
          gravity: float = 9.80665, depth: float = np.inf) -> Coefficients:
    """Of the wave number k; `centre` is the height of the point for pitch above the water [m]."""
    deep = k * np.tanh(k * depth)  # ω²/g
    omega = np.sqrt(gravity * deep)
    finite = None
    if np.isfinite(depth):
        corners = panels.corners.reshape(-1, 3)
        reach = 2 * np.linalg.norm(corners[:, :2], axis=1).max()
        finite = of_depth(deep, depth, reach, -corners[:, 2].min())
    at, normals, areas = panels.centroids, panels.normals, 4 * panels.areas
    pitch = (at[:, 2] - centre) * normals[:, 0] - at[:, 0] * normals[:, 2]
    modes = np.stack([normals[:, 0], normals[:, 2], pitch], axis=1)
    phi = potentials(panels, modes, deep, finite)
    radiation = -density * np.einsum("ni,nj,n->ij", modes, phi, areas)
    radiation[kHeave, [kSurge, kPitch]] = radiation[[kSurge, kPitch], kHeave] = 0
    # Over the four images, the even or the odd part of the wave acts.
    points, weights = panels.points()
    bottom = 0 if finite is None else np.exp(-2 * k * (depth + points[..., 2]))
    head = np.exp(k * points[..., 2]) * (1 + bottom)
    if finite:
        head /= 1 + np.exp(-2 * k * depth)
    rise = (1 - bottom) / (1 + bottom)  # The slope of the head over k.
    even, odd = head * np.cos(k * points[..., 0]), 1j * head * np.sin(k * points[..., 0])
    part = lambda mode: odd if kParities[mode][0] < 0 else even
    lever = ((points[..., 2] - centre) * normals[:, None, 0]
             - points[..., 0] * normals[:, None, 2])
    arms = (normals[:, None, 0] + 0 * lever, normals[:, None, 2] + 0 * lever, lever)
    froude_krylov = np.array([-4 * density * gravity * np.sum(arms[i] * part(i) * weights)
                              for i in range(3)])
    # φ0 = -i (g/ω) e^{kz + ikx}; its slope along x turns even into odd.
    flow = lambda mode: -1j * gravity / omega * k * (
        1j * normals[:, None, 0] * (even if part(mode) is odd else odd)
        + normals[:, None, 2] * rise * part(mode))
    diffraction = np.array([4j * density * omega
                            * np.sum(phi[:, None, i] * flow(i) * weights) for i in range(3)])
    return Coefficients(radiation.real, omega * radiation.imag, froude_krylov + diffraction,
                        froude_krylov)


def motions(found: Coefficients, inertia: Inertia, k: float,
            gravity: float = 9.80665) -> np.ndarray:
    """Complex surge and heave [m/m] and pitch over the slope k a, about the centre of mass, which
    is the point of `found`."""
    omega = np.sqrt(gravity * k)
    mass = np.diag([inertia.mass, inertia.mass, inertia.pitch])
    stiffness = np.diag([0, inertia.heave_stiffness, inertia.pitch_stiffness])
    matrix = (-omega**2 * (mass + found.added_mass) - 1j * omega * found.damping + stiffness)
    return np.linalg.solve(matrix, found.excitation) / (1, 1, k)


# Hulls -------------------------------------------------------------------------------------------

def revolved(radii: np.ndarray, heights: np.ndarray, around: int) -> Panels:
    """The quarter of a body of revolution about z, whose profile runs from the bottom up."""
    angles = np.linspace(0, np.pi / 2, around + 1)
    ring = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)
    rows = [radius * ring + (0, 0, height) for radius, height in zip(radii, heights)]
    quads = [np.stack([low[:-1], low[1:], high[1:], high[:-1]], axis=1)
             for low, high in zip(rows, rows[1:])]
    return Panels(np.concatenate(quads))


def hemisphere(radius: float, rows: int, around: int) -> Panels:
    """The flat panels are scaled to the smooth body's volume."""
    angles = np.linspace(np.pi / 2, 0, rows + 1)
    panels = revolved(radius * np.cos(angles), -radius * np.sin(angles), around)
    volume = 4 * np.sum(panels.area_vectors[:, 0] * panels.centroids[:, 0])
    return Panels(panels.corners * (2 / 3 * np.pi * radius**3 / volume)**(1 / 3))


def spar(radius: float, draft: float, rows: int, around: int) -> Panels:
    """A cylinder, scaled to the smooth one's section; panels are finer towards its ends."""
    fine = np.sin(np.linspace(0, np.pi / 2, 9))
    down = draft * (np.cos(np.linspace(0, np.pi, rows + 1)) - 1) / 2
    wide = radius * np.sqrt(np.pi / (2 * around) / np.sin(np.pi / (2 * around)))
    radii = wide * np.append(fine, np.ones(rows))
    return revolved(radii, np.append(np.full(9, -draft), down[::-1][1:]), around)


def barge(length: float, breadth: float, draft: float, counts: tuple[int, int, int]) -> Panels:
    """A box; panels are finer towards the edges."""
    x = length / 2 * np.sin(np.linspace(0, np.pi / 2, counts[0] + 1))
    y = breadth / 2 * np.sin(np.linspace(0, np.pi / 2, counts[1] + 1))
    z = -draft * (1 - np.cos(np.linspace(0, np.pi, counts[2] + 1))) / 2

    def grid(u, v, place):
        return [[place(a, c), place(b, c), place(b, d), place(a, d)]
                for a, b in zip(u, u[1:]) for c, d in zip(v, v[1:])]

    z = z[::-1]
    ends = grid(y, z, lambda b, c: (length / 2, b, c))
    sides = grid(z, x, lambda c, a: (a, breadth / 2, c))
    bottom = grid(y, x, lambda b, a: (a, b, -draft))
    return Panels(np.array(ends + sides + bottom))
