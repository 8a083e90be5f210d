"""The exact answers against brute-force sums of what they are the integrals of."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools" / "validation"))

import numpy as np  # noqa: E402

import case  # noqa: E402
import closed_forms as exact  # noqa: E402
import convergence  # noqa: E402
import drag_bodies  # noqa: E402
import fit_drag  # noqa: E402
import meshes  # noqa: E402
import shadow  # noqa: E402
import towed_sphere  # noqa: E402
import uv_sphere  # noqa: E402
from reference_values import value  # noqa: E402


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


class AddedMass(unittest.TestCase):
    def test_lambs_integrals_of_a_spheroid_are_elementary(self):
        # Prolate, e = sqrt(3)/2: alpha = 2 (1 - e^2)/e^3 (artanh e - e).
        e = np.sqrt(3) / 2
        along = 2 * (1 - e**2) / e**3 * (np.arctanh(e) - e)
        across = 1 / e**2 - (1 - e**2) / e**3 * np.arctanh(e)
        np.testing.assert_allclose(exact.lamb_integrals((2, 1, 1)), [along, across, across],
                                   rtol=1e-10)
        np.testing.assert_allclose(exact.lamb_integrals((3, 2, 1)).sum(), 2, rtol=1e-10)

    def test_a_sphere_has_half_its_mass_and_no_moment(self):
        np.testing.assert_allclose(exact.lamb_coefficients((2, 2, 2)), [0.5] * 3, rtol=1e-10)
        self.assertEqual(list(exact.lamb_rotation((2, 2, 2))), [0, 0, 0])

    def test_a_thin_disc_turns_as_lamb_says(self):
        # Oblate and flat: 16/45 of rho a^5 about a diameter, 8/3 of rho a^3 along the axis; the
        # thickness c = 1e-3 a adds a part of its own order.
        volume = 4 / 3 * np.pi * 1e-3
        self.assertAlmostEqual(exact.lamb_coefficients((1, 1, 1e-3))[2] * volume * 3 / 8, 1, 2)
        self.assertAlmostEqual(exact.lamb_rotation((1, 1, 1e-3))[0] * volume * 45 / 16, 1, 2)

    def test_munks_moment_follows(self):
        moment = exact.munk_moment(exact.lamb_coefficients((2, 1, 1)), (2, 1, 1), 1000)
        self.assertAlmostEqual(moment, 2070.08, 2)


class Meshes(unittest.TestCase):
    def assert_closed(self, mesh):
        edges = mesh[1][:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        there = sorted(map(tuple, edges.tolist()))
        self.assertEqual(there, sorted(map(tuple, edges[:, ::-1].tolist())))
        self.assertEqual(len(there), len(set(there)))

    def test_regular_solids_are_closed_and_have_their_volumes(self):
        # By edge a: tetrahedron sqrt(2)/12, octahedron sqrt(2)/3, dodecahedron (15 + 7 sqrt(5))/4,
        # icosahedron 5 (3 + sqrt(5))/12.
        root = np.sqrt(5)
        for mesh, faces, coefficient in (
                (meshes.tetrahedron(), 4, np.sqrt(2) / 12),
                (meshes.octahedron(), 8, np.sqrt(2) / 3),
                (meshes.dodecahedron(), 36, (15 + 7 * root) / 4),
                (meshes.icosahedron(), 20, 5 * (3 + root) / 12)):
            vertices = mesh[0]
            gaps = np.linalg.norm(vertices[:, None] - vertices, axis=2)
            edge = gaps[gaps > 1e-9].min()
            self.assert_closed(mesh)
            self.assertEqual(len(mesh[1]), faces)
            np.testing.assert_allclose(meshes.volume(mesh), coefficient * edge**3, rtol=1e-12)

    def test_round_meshes_are_closed_and_tend_to_their_bodies(self):
        sphere = meshes.geodesic_sphere(7)
        self.assert_closed(sphere)
        self.assertEqual([len(part) for part in sphere], [10 * 49 + 2, 20 * 49])
        np.testing.assert_allclose(np.linalg.norm(sphere[0], axis=1), 1, rtol=1e-14)
        lacks = [4 / 3 * np.pi - meshes.volume(meshes.geodesic_sphere(n)) for n in (8, 16)]
        self.assertAlmostEqual(lacks[0] / lacks[1], 4, delta=0.05)  # Of the second order.
        torus = meshes.torus_of_volume(1, 0.3, 56, 18)
        self.assert_closed(torus)
        np.testing.assert_allclose(meshes.volume(torus), 2 * np.pi**2 * 0.09, rtol=1e-12)


class DragBodies(unittest.TestCase):
    """The meshes of bodies with tabulated drag, and the law that is summed over them."""

    bodies = {body.name: body for body in drag_bodies.kBodies}

    def test_meshes_are_closed_and_face_out(self):
        self.assertEqual(len(self.bodies), 34)
        for body in drag_bodies.kBodies:
            np.testing.assert_allclose(np.sum(body.area_vectors, axis=0), 0, atol=1e-12)
            self.assertGreater(meshes.volume(body.mesh), 0)

    def test_integrals_of_front_and_back_are_the_closed_forms(self):
        # Of round bodies flat panels miss (2π/48)²/6 = 3e-3.
        for name, front, back in (("sphere", 1 / 2, 1 / 2), ("hemisphere_round", 1 / 2, 1),
                                  ("hemisphere_flat", 1, 1 / 2), ("cone_30", 1 / 4, 1),
                                  ("cone_base", 1, 1 / 4), ("cube_face", 1, 1),
                                  ("cube_edge", 1 / 2, 1 / 2), ("across_1", 2 / 3, 2 / 3),
                                  ("along_1", 1, 1), ("disc", 1, 1)):
            np.testing.assert_allclose(self.bodies[name].normal_integrals(), (front, back),
                                       rtol=5e-3, err_msg=name)

    def test_bluntness_of_ellipsoids_is_the_closed_form(self):
        expected = {"sphere": 0.5}
        for ratio in (2, 4, 8):
            e = ratio**2
            expected[f"ellipsoid_{ratio}"] = (e * np.log(e) - (e - 1)) / (e - 1)**2
        for name, value in expected.items():
            whole, finer_end, _ = self.bodies[name].bluntness
            self.assertAlmostEqual(whole, value, delta=2e-3)
            self.assertAlmostEqual(finer_end, value, delta=2e-3)  # Both ends are alike.

    def test_the_default_is_nearly_the_best_fit_and_holds_slender_bodies_better(self):
        table = fit_drag.Table()
        best = fit_drag.fit_drag(table)
        default = table.objective(drag_bodies.kDefault)
        self.assertLess(table.objective(best), default)
        self.assertLess(default, table.objective(best) + 0.015)  # Of a mean of |log|.
        worst = {law: np.max(np.abs(np.log(table.ratios(law)[table.slender])))
                 for law in (best, drag_bodies.kDefault)}
        self.assertLess(worst[drag_bodies.kDefault], worst[best])


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
            meshes.write_obj(path, drag_bodies.hemisphere(round_first=True))
            triangles = shadow.read_triangles(path)
        # A polygon of 48 corners from ahead; half of one of 96 from abeam, where a ring every
        # 90/24 degrees makes the outline.
        ahead, abeam = (0.25 * n / 2 * np.sin(2 * np.pi / n) for n in (48, 96))
        np.testing.assert_allclose(shadow.shadow_area(triangles, 0), ahead, rtol=1e-4)
        np.testing.assert_allclose(shadow.shadow_area(triangles, 1), abeam / 2, rtol=1e-4)


class Friction(unittest.TestCase):
    def test_line_of_1957_and_what_it_is_held_at(self):
        self.assertAlmostEqual(exact.ittc57(1e7), 0.003, places=15)
        self.assertAlmostEqual(exact.ittc57(1e5), 0.075 / 9, places=15)
        self.assertEqual(exact.ittc57(10), exact.ittc57(1e4))


class Motion(unittest.TestCase):
    def test_heave_period(self):
        self.assertAlmostEqual(exact.heave_period(0.15, 7.056, 998.2, 9.82, 0.03), 0.63725,
                               places=5)

    def test_integration_follows_the_closed_form(self):
        times = np.linspace(0, 10, 501)
        ours = exact.integrate(lambda t, w: -0.4 * w * w, 5, times)
        np.testing.assert_allclose(ours, 5 / (1 + 2 * times), rtol=1e-6)


class CornerUp(unittest.TestCase):
    """The cube of half the water's density."""

    def energy(self, x, y):
        """About the diagonal, x towards the face diagonals, y square to it [rad]."""
        axes = (np.array([1, 1, -2]) / np.sqrt(6), np.array([1, -1, 0]) / np.sqrt(2))
        angle = np.hypot(x, y)
        way = (x * axes[0] + y * axes[1]) / angle if angle else axes[0]
        return exact.cube_mean_depth(np.cos(angle) * np.ones(3) / np.sqrt(3) + np.sin(angle) * way)

    def test_mean_depth_is_that_of_points_in_the_cube(self):
        x = (np.arange(200) + 0.5) / 100 - 1
        up = np.array([0.5, 0.6, 0.62]) / np.linalg.norm([0.5, 0.6, 0.62])
        depths = np.abs(up[0] * x[:, None, None] + up[1] * x[:, None] + up[2] * x)
        self.assertAlmostEqual(exact.cube_mean_depth(up), depths.mean(), places=4)

    def test_attitude_is_a_minimum_with_the_cubic_term_that_shifts_its_mean(self):
        h = 0.005
        e = {i: self.energy(i * h, 0) for i in (-2, -1, 0, 1, 2)}
        k = (e[1] - 2 * e[0] + e[-1]) / h**2
        c = (e[2] - 2 * e[1] + 2 * e[-1] - e[-2]) / (4 * h**3)
        self.assertGreater(k, 0)
        np.testing.assert_allclose(abs(c / k), exact.cube_corner_shift(), rtol=1e-3)
        across = (self.energy(0, h) - 2 * e[0] + self.energy(0, -h)) / h**2
        np.testing.assert_allclose(across, k, rtol=1e-3)


class Polyhedron(unittest.TestCase):
    """The UV sphere by its own panels."""

    def test_tends_to_the_sphere(self):
        errors = []
        for count in (20, 40):
            sphere = uv_sphere.SpinningSphere(1.5, count, count)
            errors.append([
                sphere.torque(2, 1000, 0.1) / exact.sphere_spin_torque(1.5, 2, 1000, 0.1) - 1,
                sphere.moment_of_inertia(3) / (8 / 15 * np.pi * 3 * 1.5**5) - 1])
        np.testing.assert_allclose(np.array(errors[0]) / errors[1], 4, rtol=0.02)

    def test_law_of_the_thesis_tends_to_the_sphere_s(self):
        sphere = uv_sphere.SpinningSphere(1, 80, 80)
        for omega in (0.5, 1.5, 3):
            smooth = exact.sphere_spin_torque_of_law(1, omega, 1000,
                                                     exact.thesis_viscous_coefficient)
            np.testing.assert_allclose(sphere.torque_of_thesis_law(omega, 1000), smooth, rtol=0.01)


class Waves(unittest.TestCase):
    def test_moments_against_a_sum(self):
        omega = (np.arange(400000) + 0.5) * exact.kHighest / 400000 * 2 * np.pi / 8
        shape = exact.jonswap_shape(omega * 8 / (2 * np.pi), 3.3)
        for order in (-1, 0, 1, 2):
            total = np.sum(omega**order * shape) * (omega[1] - omega[0])
            np.testing.assert_allclose(exact.jonswap_moment(3.3, 8, order), total, rtol=1e-7)

    def test_mean_period_is_the_tabulated_one_but_for_the_cut(self):
        # The tail of omega^-4 above 20 omega_p has 1.6e-4 of the first moment.
        for gamma in (1, 3.3, 7):
            ratio = value(f"jonswap.t01.{gamma:g}")
            period = (2 * np.pi * exact.jonswap_moment(gamma, 8, 0)
                      / exact.jonswap_moment(gamma, 8, 1))
            self.assertAlmostEqual(period / 8 / ratio, 1, delta=2e-4)

    def test_bands_keep_the_first_moment(self):
        bands = exact.jonswap_bands(3.3, 8, 37)
        self.assertTrue(np.all(np.diff(bands) > 0))
        mean = exact.jonswap_moment(3.3, 8, 1) / exact.jonswap_moment(3.3, 8, 0)
        np.testing.assert_allclose(bands.mean(), mean, rtol=1e-7)


class Convergence(unittest.TestCase):
    def test_extrapolation_takes_the_leading_error_away(self):
        values = [5 + 3 * h**2 + h**4 for h in (0.4, 0.2, 0.1)]
        limit, doubt = convergence.extrapolated(values, 2)
        self.assertLess(abs(limit - 5), doubt)
        self.assertLess(doubt, 0.3 * abs(values[2] - 5))
        self.assertEqual(convergence.whole_order(values), 2)

    def test_a_bias_that_no_mesh_takes_away_fails(self):
        rows = convergence.mesh_rows("x", "m", 5.01, [5 + 3 * h**2 for h in (0.4, 0.2, 0.1)],
                                     "finest")
        self.assertFalse(rows[1].passed or rows[2].passed)  # The order, the extrapolated value.
        rows = convergence.mesh_rows("x", "m", 5, [5 + 3 * h**2 + h**4 for h in (0.2, 0.1, 0.05)],
                                     "finest")
        self.assertTrue(all(row.passed for row in rows))

    def test_a_scheme_of_half_the_order_fails(self):
        rows = convergence.step_order_rows("x", [5 + h**0.5 for h in (0.4, 0.2, 0.1)], 1e-9)
        self.assertFalse(rows[0].passed)
        self.assertEqual(convergence.step_order_rows("x", [5, 5, 5 + 1e-10], 1e-9), [])

    def test_an_exact_row_admits_round_off_only(self):
        with self.assertRaises(ValueError):
            case.compare("x", "m", 1, 1, 1e-8)


if __name__ == "__main__":
    unittest.main()
