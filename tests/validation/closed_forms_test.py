"""The exact answers against brute-force sums of what they are the integrals of."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools" / "validation"))

import numpy as np  # noqa: E402

import bluff_bodies  # noqa: E402
import closed_forms as exact  # noqa: E402
import fit_drag  # noqa: E402
import shadow  # noqa: E402
import towed_sphere  # noqa: E402
from cases import friction  # noqa: E402


def sphere_points(count: int = 1000):
    """Normals and areas of a unit sphere's rings and slices; the midpoint rule, error 1e-6."""
    theta = (np.arange(count) + 0.5) * np.pi / count
    phi = (np.arange(count) + 0.5) * 2 * np.pi / count
    sine = np.sin(theta)[:, None]
    normals = np.stack([sine * np.cos(phi), sine * np.sin(phi),
                        np.cos(theta)[:, None] + 0 * phi[None, :]])
    return normals, sine * (np.pi / count) * (2 * np.pi / count) + 0 * phi[None, :]


class Sphere(unittest.TestCase):
    def setUp(self):
        self.n, self.area = sphere_points()
        self.tangential = np.sqrt(1 - self.n[0]**2)

    def test_drag_and_lift(self):
        sums = [np.sum(np.abs(self.n[0])**3 * self.area), np.sum(self.tangential**3 * self.area),
                -np.sum((self.tangential**2 * self.n[2] * self.area)[self.n[2] < 0])]
        forms = [exact.sphere_pressure_drag(1, 1, 2, 1), exact.sphere_viscous_drag(1, 1, 2, 1),
                 exact.half_sphere_lift(1, 1, 2, 1)]
        np.testing.assert_allclose(forms, sums, rtol=1e-5)

    def test_spin(self):
        rim = np.sqrt(self.n[0]**2 + self.n[1]**2)
        np.testing.assert_allclose(exact.sphere_spin_torque(1, 1, 2, 1), np.sum(rim**3 * self.area),
                                   rtol=1e-5)
        law = exact.sphere_spin_torque_of_law(1, 1, 2, lambda speed: 1 + 0 * speed)
        np.testing.assert_allclose(law, exact.sphere_spin_torque(1, 1, 2, 1), rtol=1e-6)

    def test_a_tow_of_a_half_immersed_sphere(self):
        tow = towed_sphere.Tow(1, 1, 1, 2, 1, 1, 1)
        viscous = np.sum(self.area * self.tangential**3 * 3 * 3
                         * exact.thesis_viscous_coefficient(3 * self.tangential))
        drag = exact.sphere_pressure_drag(1, 3, 2, 1)
        self.assertAlmostEqual(towed_sphere.resistance(tow, 0, 3), 0.5 * (drag + viscous),
                               delta=1e-3)
        self.assertAlmostEqual(towed_sphere.lift(tow, 0, 3), exact.half_sphere_lift(1, 3, 2, 1),
                               delta=1e-9)

    def test_polyhedron_tends_to_the_sphere(self):
        below = exact.uv_sphere_volume_below(1, 800, 800, -0.3)
        np.testing.assert_allclose(below, exact.cap_volume(1, 0.7), rtol=1e-4)


class Cube(unittest.TestCase):
    def test_spin(self):
        x = (np.arange(2000) + 0.5) / 2000 - 0.5
        ends = np.mean(np.hypot(x[:, None], x[None, :])**3)
        side = 0.5**3
        np.testing.assert_allclose(exact.cube_spin_viscous_torque(1, 1, 1, 1), ends + 2 * side,
                                   rtol=1e-6)
        np.testing.assert_allclose(exact.cube_spin_viscous_torque(1, 1, 1, 1), 0.328398, atol=5e-7)
        np.testing.assert_allclose(exact.cube_spin_pressure_torque(1, 1, 1, 1),
                                   0.5 * 4 * np.mean(np.abs(x)**3), rtol=1e-6)

    def test_flat_floating_tilt_grows(self):
        self.assertAlmostEqual(exact.cube_tilt_growth_rate(2, 0.55, 9.80665), 1.4703, places=4)


class Cylinder(unittest.TestCase):
    def test_prism_tends_to_the_cylinder(self):
        np.testing.assert_allclose(exact.prism_pressure_area(0.5, 2, 4000), 8 / 3, rtol=1e-5)


class Box(unittest.TestCase):
    def test_righting_arm_is_the_wedges_moment(self):
        heel, breadth, draft, center = np.radians(20), 4.0, 1.2, 1.3
        y = breadth * ((np.arange(200000) + 0.5) / 200000 - 0.5)
        depth = draft - y * np.tan(heel)  # Of the keel, along z of the box.
        volume, across = np.mean(depth), np.mean(depth * y) / np.mean(depth)
        above_keel = np.mean(depth**2 / 2) / volume
        arm = -across * np.cos(heel) + (above_keel - center) * np.sin(heel)
        self.assertAlmostEqual(exact.box_gz(breadth, draft, center, heel), arm, places=8)


class BluffBodies(unittest.TestCase):
    """The integrals of front and back, over the panels of the meshes that the cases use."""

    def sums(self, profile):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "mesh.obj"
            bluff_bodies.write_turned(path, profile)
            triangles = shadow.read_triangles(path)
        twice = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        area = np.linalg.norm(twice, axis=1) / 2
        part = area * (twice[:, 0] / (2 * area))**3 / bluff_bodies.kCircle
        np.testing.assert_allclose(np.sum(twice, axis=0), 0, atol=1e-12)  # The mesh is closed.
        return np.sum(part[part > 0]), -np.sum(part[part < 0])

    def test_meshes_have_the_closed_forms_on_either_side(self):
        forms = {body.name: (body.front, body.back) for body in bluff_bodies.kBodies}
        hemisphere = self.sums(bluff_bodies.hemisphere_profile())
        cone = self.sums(bluff_bodies.cone_profile())
        np.testing.assert_allclose(hemisphere, forms["hemisphere_round"], rtol=2e-3)
        np.testing.assert_allclose(hemisphere[::-1], forms["hemisphere_flat"], rtol=2e-3)
        np.testing.assert_allclose(cone, forms["cone_point"], rtol=2e-3)
        np.testing.assert_allclose(cone[::-1], forms["cone_base"], rtol=2e-3)

    def test_no_pair_near_the_fit_is_better(self):
        fit = fit_drag.fit_drag()
        around = np.linspace(-0.1, 0.1, 21)
        near = fit_drag.objective(*np.meshgrid(fit.front + around, fit.back + around))
        self.assertGreaterEqual(np.min(near), fit.objective - 1e-12)
        self.assertLess(fit.objective, float(fit_drag.objective(0.6316, 0.6316)))


class Shadow(unittest.TestCase):
    def test_an_area_under_two_triangles_counts_once(self):
        # The L of two rectangles of 2 x 1 and 1 x 2 that share a square, the second twice and
        # upside down.
        def rectangle(x, y, z):
            p = np.array([[0, 0, z], [x, 0, z], [x, y, z], [0, y, z]], float)
            return [p[[0, 1, 2]], p[[0, 2, 3]]]
        faces = rectangle(2, 1, 0) + rectangle(1, 2, 1) + [t[::-1] for t in rectangle(1, 2, 5)]
        self.assertAlmostEqual(shadow.shadow_area(np.array(faces), 2), 3, delta=1e-9)

    def test_of_a_hemisphere_of_panels(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "mesh.obj"
            bluff_bodies.write_turned(path, bluff_bodies.hemisphere_profile())
            triangles = shadow.read_triangles(path)
        # A polygon of 96 corners from ahead; half of one of 192 from abeam, where a ring every
        # 90/48 degrees makes the outline.
        ahead, abeam = (0.25 * n / 2 * np.sin(2 * np.pi / n) for n in (96, 192))
        np.testing.assert_allclose(shadow.shadow_area(triangles, 0), ahead, rtol=1e-4)
        np.testing.assert_allclose(shadow.shadow_area(triangles, 1), abeam / 2, rtol=1e-4)


class Friction(unittest.TestCase):
    def test_line_of_1957_and_what_it_is_held_at(self):
        self.assertAlmostEqual(friction.ittc57(1e7), 0.003, places=15)
        self.assertAlmostEqual(friction.ittc57(1e5), 0.075 / 9, places=15)
        self.assertEqual(friction.ittc57(10), friction.ittc57(1e4))


class Motion(unittest.TestCase):
    def test_heave_period(self):
        self.assertAlmostEqual(exact.heave_period(0.15, 7.056, 998.2, 9.82, 0.03), 0.63725,
                               places=5)

    def test_integration_follows_the_closed_form(self):
        times = np.linspace(0, 10, 501)
        ours = exact.integrate(lambda t, w: -0.4 * w * w, 5, times)
        np.testing.assert_allclose(ours, 5 / (1 + 2 * times), rtol=1e-6)


if __name__ == "__main__":
    unittest.main()
