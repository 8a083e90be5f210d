"""Exact answers, derived outside the program: closed forms, and quadratures of smooth functions.

SI units. `quadrature` is exact to round-off for what it is used on here; the tests of this file
compare each form with a brute-force sum.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

kGravity = 9.80665  # The program's default [m/s^2].


def quadrature(f: Callable, a: float, b: float, points: int = 200) -> float:
    """Gauss–Legendre."""
    x, weights = np.polynomial.legendre.leggauss(points)
    return float(np.sum(weights * f(0.5 * (a + b) + 0.5 * (b - a) * x)) * 0.5 * (b - a))


# Sphere ------------------------------------------------------------------------------------------

def cap_volume(radius: float, depth: float) -> float:
    """Volume of a sphere that is immersed to `depth` below the surface."""
    d = min(max(depth, 0.0), 2 * radius)
    return np.pi * d * d * (3 * radius - d) / 3


def uv_sphere_volume_below(radius: float, slices: int, stacks: int, z: float) -> float:
    """Volume of the part below z of the polyhedron that a UV sphere is: frusta whose sections are
    regular polygons and whose circumradius is linear in z between the rings."""
    angles = np.linspace(np.pi, 0, stacks + 1)
    rings_z, rings_r = radius * np.cos(angles), radius * np.sin(angles)
    section = 0.5 * slices * np.sin(2 * np.pi / slices)
    volume = 0.0
    for (za, zb), (ra, rb) in zip(zip(rings_z, rings_z[1:]), zip(rings_r, rings_r[1:])):
        top = min(max(z, za), zb)
        r = ra + (rb - ra) * (top - za) / (zb - za)
        volume += section * (top - za) * (ra * ra + ra * r + r * r) / 3
    return volume


def sphere_pressure_drag(radius: float, speed: float, density: float, c_p: float) -> float:
    """-F of a submerged sphere: the integral of v_n |v_n| cos over the sphere is pi R^2 v^2."""
    return 0.5 * density * c_p * np.pi * radius**2 * speed**2


def sphere_viscous_drag(radius: float, speed: float, density: float, c_v: float) -> float:
    """-F for constant C_v: the integral of sin^3 over the sphere is 3 pi^2 R^2 / 4."""
    return 0.5 * density * c_v * 0.75 * np.pi**2 * radius**2 * speed**2


def half_sphere_lift(radius: float, speed: float, density: float, c_l: float) -> float:
    """F_z of a half-immersed sphere in level motion: the integral of (1 - n_x^2) n_z over the
    lower half is -3 pi R^2 / 4."""
    return 0.5 * density * c_l * 0.75 * np.pi * radius**2 * speed**2


def sphere_spin_torque(radius: float, omega: float, density: float, c_v: float) -> float:
    """-M of a spinning sphere for constant C_v: the integral of sin^3 over the sphere again."""
    return 3 * np.pi**2 / 8 * density * c_v * omega**2 * radius**5


# Linear waves ------------------------------------------------------------------------------------

def bessel(order: int, x: np.ndarray) -> np.ndarray:
    """J_0 or J_1: the mean over a turn of cos(x cos φ), or of sin(x cos φ) cos φ."""
    phi = np.pi * (np.arange(64) + 0.5) / 32
    along = np.multiply.outer(x, np.cos(phi))
    return np.mean(np.sin(along) * np.cos(phi) if order else np.cos(along), axis=-1)


def hemisphere_froude_krylov(k_radius: float) -> tuple[float, float]:
    """Amplitudes of heave and surge over ρ g π R² a, of the pressure e^{kz} cos kx on a hemisphere
    below the water: integrals over the angle from the downward axis."""
    decay = lambda t: np.exp(-k_radius * np.cos(t))
    heave = lambda t: 2 * decay(t) * bessel(0, k_radius * np.sin(t)) * np.cos(t) * np.sin(t)
    surge = lambda t: 2 * decay(t) * bessel(1, k_radius * np.sin(t)) * np.sin(t)**2
    return quadrature(heave, 0, np.pi / 2, 40), quadrature(surge, 0, np.pi / 2, 40)


@dataclass(frozen=True)
class DeepWave:
    """Of the program: ξ = a cos θ with θ = kx − ωt, and the exponential's height is counted from
    the surface (Wheeler)."""

    amplitude: float
    number: float
    gravity: float = kGravity

    @property
    def omega(self) -> float:
        return np.sqrt(self.gravity * self.number)

    def _theta_and_decay(self, place, t):
        theta = self.number * place[0] - self.omega * t
        return theta, np.exp(self.number * (place[1] - self.amplitude * np.cos(theta)))

    def velocity(self, place, t) -> np.ndarray:
        """At x, z [m/s]."""
        theta, decay = self._theta_and_decay(place, t)
        return self.amplitude * self.omega * decay * np.array([np.cos(theta), np.sin(theta)])

    def acceleration(self, place, t) -> np.ndarray:
        """∂u/∂t of linear theory [m/s²]."""
        theta, decay = self._theta_and_decay(place, t)
        return self.amplitude * self.omega**2 * decay * np.array([np.sin(theta), -np.cos(theta)])

    def path(self, place, times: np.ndarray) -> np.ndarray:
        """Of a drop, by the classical Runge–Kutta method from one time to the next."""
        path = [np.asarray(place, float)]
        for t, h in zip(times, np.diff(times)):
            a = self.velocity(path[-1], t)
            b = self.velocity(path[-1] + h / 2 * a, t + h / 2)
            c = self.velocity(path[-1] + h / 2 * b, t + h / 2)
            d = self.velocity(path[-1] + h * c, t + h)
            path.append(path[-1] + h / 6 * (a + 2 * b + 2 * c + d))
        return np.array(path)

    def drift_at_surface(self) -> float:
        """Mean velocity of what stays on the surface and moves along with the water there,
        ẋ = a ω cos(kx − ωt): c (1 − (1 − (ka)²)^½), about half of Stokes' c (ka)²."""
        return self.omega / self.number * (1 - np.sqrt(1 - (self.number * self.amplitude)**2))


# Cube, edge a, spinning about an axis through two face centres -----------------------------------

# Integral of r^3 over the unit square about its centre: (1/20) of the integral of sec^5 from 0 to
# pi/4.
kSquareThirdMoment = (7 * np.sqrt(2) / 8 + 3 / 8 * np.log(1 + np.sqrt(2))) / 20


def cube_spin_pressure_torque(edge: float, omega: float, density: float, c_p: float) -> float:
    """-M: four faces, v_n = omega y, so 4 a 2 (1/2) rho C_p omega^2 (a/2)^4 / 4."""
    return density * c_p * omega**2 * edge**5 / 16


def cube_spin_viscous_torque(edge: float, omega: float, density: float, c_v: float) -> float:
    """-M: on the four side faces v_t = omega a/2 everywhere, on the two end faces omega r."""
    return (0.25 + kSquareThirdMoment) * density * c_v * omega**2 * edge**5


# Drag of the thesis's four tests, per density C_p v^2 --------------------------------------------

def prism_pressure_area(radius: float, height: float, sides: int) -> float:
    """Integral of |n_x|^3 over the sides of a regular prism about z whose edges start at angle 0;
    towards 8/3 R H for a cylinder."""
    angles = (np.arange(sides) + 0.5) * 2 * np.pi / sides
    width = 2 * radius * np.sin(np.pi / sides)
    return float(np.sum(np.abs(np.cos(angles))**3) * width * height)


# Floating bodies ---------------------------------------------------------------------------------

def box_gz(breadth: float, draft: float, center_above_keel: float, heel: float) -> float:
    """Righting arm of a wall-sided box: sin(heel) (GM + BM/2 tan^2(heel)), exact until the deck
    goes under or the bilge comes out."""
    bm = breadth**2 / (12 * draft)
    gm = draft / 2 + bm - center_above_keel
    return np.sin(heel) * (gm + 0.5 * bm * np.tan(heel)**2)


def cube_tilt_growth_rate(edge: float, relative_density: float, gravity: float) -> float:
    """Growth rate of a small tilt of a cube that floats flat, under buoyancy alone [1/s]:
    sigma^2 = -m g GM / I with I = m a^2 / 6."""
    draft = relative_density * edge
    gm = draft / 2 + edge**2 / (12 * draft) - edge / 2
    return np.sqrt(-gravity * gm / (edge**2 / 6))


def cube_mean_depth(up: np.ndarray) -> float:
    """Mean of |z| over a cube of edge 2 whose centre is in the water's surface, for an upward unit
    vector in its axes that meets the hexagon about a diagonal. The potential energy of a cube of
    half the water's density is proportional to it."""
    total = np.sum(up)
    return float((total**4 - np.sum((total - 2 * up)**4)) / (96 * np.prod(up)))


def cube_corner_shift() -> float:
    """How the mean attitude of a cube that floats corner up moves while it oscillates, over the
    mean square of the angle. About a diagonal the energy is k r^2/2 + c (x^3 - 3 x y^2)/3, by its
    threefold symmetry; the mean of the moment vanishes, so the mean of x + iy is c/k times the
    mean of the conjugate of -(x + iy)^2. c/k = 9/sqrt(8)."""
    return 9 / np.sqrt(8)


# Added mass --------------------------------------------------------------------------------------

kLambAxes = ((2, 1, 1), (3, 2, 1))  # Semi-axes of the ellipsoids that are compared [m].


def lamb_integrals(axes) -> np.ndarray:
    """alpha_i = abc times the integral of dl / ((a_i^2 + l) sqrt((a^2 + l)(b^2 + l)(c^2 + l))) over
    l > 0; their sum is 2. With l = (t/(1 - t))^2 the integrand is smooth on (0, 1)."""
    squares = np.array(axes, float)[:, None]**2

    def integrand(t, i):
        u = t / (1 - t)
        root = np.sqrt(np.prod(squares + u**2, axis=0))
        return 2 * u / (1 - t)**2 / ((squares[i] + u**2) * root)

    return np.array([np.prod(axes) * quadrature(lambda t: integrand(t, i), 0, 1)
                     for i in range(3)])


def lamb_coefficients(axes) -> np.ndarray:
    """Added mass of an ellipsoid along its axes, over rho V."""
    alpha = lamb_integrals(axes)
    return alpha / (2 - alpha)


def lamb_rotation(axes) -> np.ndarray:
    """Added moment of inertia about its axes, over rho V [m^2]: Lamb, Hydrodynamics, 115."""
    alpha, squares = lamb_integrals(axes), np.array(axes, float)**2
    moments = []
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        lever, swing = squares[j] - squares[k], alpha[k] - alpha[j]
        both = squares[j] + squares[k]
        moments.append(lever**2 * swing / (2 * lever - both * swing) / 5 if lever else 0.0)
    return np.array(moments)


def munk_moment(coefficients, axes, density: float) -> float:
    """Of an ellipsoid at 1 m/s, 45 degrees from its first axis towards the second [N m]."""
    return 0.5 * (coefficients[1] - coefficients[0]) * density * 4 / 3 * np.pi * np.prod(axes)


# Motion ------------------------------------------------------------------------------------------

def heave_period(radius: float, mass: float, density: float, gravity: float,
                 amplitude: float) -> float:
    """Period of a half-immersed sphere that bobs without losses and without added mass, from the
    conservation of energy: a quarter of it is the integral of dz / v from 0 to the amplitude."""

    def work(z):  # Done by buoyancy minus weight from z = 0 (force is odd in z).
        return density * gravity * np.pi * (radius**2 * z**2 / 2 - z**4 / 12)

    def integrand(theta):
        z = amplitude * np.sin(theta)
        return amplitude * np.cos(theta) / np.sqrt(2 * (work(amplitude) - work(z)) / mass)

    return 4 * quadrature(integrand, 0, np.pi / 2)


def thesis_viscous_coefficient(speed: np.ndarray) -> np.ndarray:
    """C_v of the thesis, Table 2."""
    return np.clip(np.minimum(0.1, 0.2 - 0.1 * speed), 0, None)


def ittc57(reynolds: np.ndarray) -> np.ndarray:
    """C_v of the ITTC 1957 line, as the program holds it below Re = 1e4."""
    return 0.075 / (np.log10(np.maximum(reynolds, 1e4)) - 2)**2


def sphere_spin_torque_of_law(radius: float, omega: float, density: float,
                              law: Callable) -> float:
    """-M of a spinning sphere for a C_v that depends on the tangential speed."""
    theta = (np.arange(4000) + 0.5) * np.pi / 4000
    speed = abs(omega) * radius * np.sin(theta)
    ring = 2 * np.pi * radius**2 * np.sin(theta) * (np.pi / 4000)
    return float(np.sum(0.5 * density * law(speed) * speed**2 * radius * np.sin(theta) * ring))


def integrate(rate: Callable[[float, float], float], start: float,
              times: np.ndarray) -> np.ndarray:
    """dw/dt = rate(t, w) at the times given, by the classical Runge–Kutta method. Breaks of the
    rate should lie on the times."""
    values = [start]
    for a, b in zip(times, times[1:]):
        h, w = b - a, values[-1]
        k1 = rate(a, w)
        k2 = rate(0.5 * (a + b), w + 0.5 * h * k1)
        k3 = rate(0.5 * (a + b), w + 0.5 * h * k2)
        k4 = rate(np.nextafter(b, a), w + h * k3)
        values.append(w + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4))
    return np.array(values)


# Waves -------------------------------------------------------------------------------------------

kHighest = 20.0  # Where the program cuts its spectrum off, over the peak's frequency.


def jonswap_shape(ratio: np.ndarray, gamma: float) -> np.ndarray:
    """JONSWAP density over ratio = omega/omega_p, without its scale."""
    width = np.where(ratio <= 1, 0.07, 0.09)
    peak = np.exp(-(ratio - 1)**2 / (2 * width**2))
    return ratio**-5.0 * np.exp(-1.25 * ratio**-4.0) * gamma**peak


def jonswap_moment(gamma: float, peak_period: float, order: int) -> float:
    """Integral of omega^order times the shape up to the cut, by Gauss on either side of the peak,
    in the shape's scale."""
    peak = 2 * np.pi / peak_period
    edges = (0.2, 0.6, 1, 1.4, 2, 4, 8, kHighest)
    return peak**(order + 1) * sum(
        quadrature(lambda r: r**order * jonswap_shape(r, gamma), a, b)
        for a, b in zip(edges, edges[1:]))


def jonswap_bands(gamma: float, peak_period: float, count: int, steps: int = 40000) -> np.ndarray:
    """Mean frequencies of bands of equal energy [rad/s], by the midpoint rule with as many steps
    as the program has, the steps at a band's ends shared between two bands."""
    ratio = (np.arange(steps) + 0.5) * kHighest / steps
    energy = jonswap_shape(ratio, gamma).astype(np.longdouble)
    running = np.concatenate([[0], np.cumsum(energy)])
    moment = np.concatenate([[0], np.cumsum(energy * ratio)])
    ends = running[-1] * np.arange(count + 1) / count
    at = np.clip(np.searchsorted(running, ends, side="right") - 1, 0, steps - 1)
    at_ends = moment[at] + (ends - running[at]) * ratio[at]
    means = np.diff(at_ends) * count / running[-1]
    return (means * 2 * np.pi / peak_period).astype(float)
