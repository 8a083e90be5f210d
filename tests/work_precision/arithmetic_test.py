"""The arithmetic of tools/benchmark --accuracy, on series whose errors and times are known."""

import sys
import unittest
from pathlib import Path as File

kTools = File(__file__).resolve().parents[2] / "tools"
sys.path[:0] = [str(kTools / "work_precision"), str(kTools / "validation")]

import numpy as np  # noqa: E402

import exact_motion  # noqa: E402
import judgement  # noqa: E402
from experiments import kExperiments  # noqa: E402
from measurement import Cost  # noqa: E402
from rotations import from_rotation_vector, product, rotated, rotation_vector  # noqa: E402
from studies import Finding, Row  # noqa: E402
from trajectory_error import Path, extrapolated, limit_of_steps, trajectory_error  # noqa: E402

kTimes = np.arange(1, 31) / 15


def random_path(seed: int) -> Path:
    random = np.random.default_rng(seed)
    turn = from_rotation_vector(random.normal(size=(2, len(kTimes), 3)))
    return Path(kTimes, random.normal(size=(2, len(kTimes), 3)), turn)


def moved(path: Path, shift: np.ndarray, turn: np.ndarray) -> Path:
    return Path(path.times, path.position + shift,
                product(from_rotation_vector(turn), path.attitude))


class TrajectoryError(unittest.TestCase):
    def setUp(self):
        self.path = random_path(1)

    def test_is_the_shift_in_lengths(self):
        other = moved(self.path, np.array([0, 3.0, 4.0]), np.zeros(3))
        self.assertAlmostEqual(trajectory_error(other, self.path, 2), 2.5, delta=1e-14)

    def test_is_the_angle_of_a_turn_about_any_axis(self):
        other = moved(self.path, np.zeros(3), 0.3 * np.array([2, -1, 2]) / 3)
        self.assertAlmostEqual(trajectory_error(other, self.path, 2), 0.3, delta=1e-14)

    def test_does_not_see_the_sign_of_a_quaternion(self):
        other = Path(kTimes, self.path.position, -self.path.attitude)
        self.assertLess(trajectory_error(other, self.path, 1), 1e-14)

    def test_refuses_other_times(self):
        other = Path(kTimes + 0.01, self.path.position, self.path.attitude)
        self.assertRaises(ValueError, trajectory_error, other, self.path, 1)


class Limit(unittest.TestCase):
    """Paths with an error c h² in position and in turn about a fixed axis."""

    def setUp(self):
        self.truth = random_path(2)
        rate = np.array([0.3, -0.2, 0.1])
        self.paths = [moved(self.truth, h**2 * rate, h**2 * rate) for h in (0.4, 0.2, 0.1)]

    def test_has_no_leading_term(self):
        limit = extrapolated(self.paths[1], self.paths[2], 2)
        self.assertLess(trajectory_error(limit, self.truth, 1), 1e-14)

    def test_of_the_wrong_order_is_wrong_and_in_doubt(self):
        limit = limit_of_steps(self.paths, 1, 1, "")
        error = trajectory_error(limit.path, self.truth, 1)
        self.assertGreater(error, 1e-3)
        self.assertGreater(limit.doubt, error)

    def test_without_an_order_is_the_last_path(self):
        last = limit_of_steps(self.paths, None, 1, "")
        self.assertEqual(trajectory_error(last.path, self.paths[2], 1), 0)
        self.assertAlmostEqual(last.doubt, trajectory_error(*self.paths[1:], 1), delta=1e-15)


class ExactMotion(unittest.TestCase):
    def test_heave_keeps_its_energy(self):
        times = np.linspace(0.001, 3, 3000)
        radius, gravity = 0.5, 9.80665
        z = exact_motion.heave_of_sphere(times, radius, 0.5, 0.2, gravity).position[0, :, 2]
        speed = np.gradient(z, times, edge_order=2)
        # Work of the immersed volume's excess over half of the sphere, πR³·(z/R − (z/R)³/3).
        potential = gravity * 1.5 * radius * ((z / radius)**2 / 2 - (z / radius)**4 / 12)
        energy = (0.5 * speed**2 + potential)[1:-1]
        start = gravity * 1.5 * radius * (0.4**2 / 2 - 0.4**4 / 12)
        # The speed is by differences, in error by z'''h²/6 < 1e-5.
        np.testing.assert_allclose(energy, start, rtol=5e-5)

    def test_pieces_are_small_enough(self):
        """The classical method's error falls by 16 with half the piece; the rest is round-off."""
        piece = exact_motion.kPiece
        motions = {
            "heave": lambda p: exact_motion.heave_of_sphere(kTimes, 0.5, 0.5, 0.2, 9.8, p),
            "pendulum": lambda p: exact_motion.pendulum(kTimes, 1.0, 1.0, 9.8, np.zeros(3), p),
            "torque-free": lambda p: exact_motion.torque_free(
                kTimes, np.diag([2.0, 3, 4, 1, 2, 3]), np.zeros(3), np.array([0.5, 0.2, 0.1]),
                np.array([0.3, 1.5, 0.2]), p)}
        for name, motion in motions.items():
            with self.subTest(name):
                self.assertLess(trajectory_error(motion(piece), motion(piece / 2), 1), 1e-11)

    def test_pendulum_returns_after_its_period(self):
        """T = 2π / (rate · agm(1, cos(θ/2))), Gauss."""
        start, rate_squared = 1.2, 7.0
        a, b = 1.0, np.cos(start / 2)
        for _ in range(6):
            a, b = (a + b) / 2, np.sqrt(a * b)
        period = 2 * np.pi / (np.sqrt(rate_squared) * a)
        path = exact_motion.pendulum(np.array([period / 2, period]), start, 0.5, rate_squared,
                                     np.array([1.0, 2, 3]))
        expected = [[1 + side * 0.5 * np.sin(start), 2, 3 - 0.5 * np.cos(start)]
                    for side in (1, -1)]
        np.testing.assert_allclose(path.position[0], expected, atol=1e-10)

    def test_sinking_obeys_its_equation(self):
        times = np.linspace(0.5, 2.5, 2001)
        weight, drag, mass = 600.0, 50.0, 130.0
        z = exact_motion.sinking(times, -2, weight, drag, mass).position[0, :, 2]
        speed = np.gradient(z, times)[2:-2]
        acceleration = np.gradient(np.gradient(z, times), times)[2:-2]
        np.testing.assert_allclose(mass * acceleration, drag * speed**2 - weight, atol=1e-2)

    def test_torque_free_follows_the_munk_instability(self):
        """A 2:1:1 spheroid set off at 1 m/s along its axis and 0.01 m/s across; made with an
        eighth-order Runge-Kutta method at 1e-13."""
        inertia = np.diag([10136.99836959496] + 2 * [14277.15987739361] + [3351.0321638291125]
                          + 2 * [10383.373326788156])
        path = exact_motion.torque_free(np.array([1.0, 2.4]), inertia, np.zeros(3),
                                        np.array([1.0, 0.01, 0]), np.zeros(3))
        np.testing.assert_allclose(path.position[0], [[0.99999700875808, 0.0098045484248536, 0],
                                                      [2.3999370251291, 0.021110673272713, 0]],
                                   atol=1e-10)

    def test_torque_free_keeps_momentum_in_the_world(self):
        inertia = np.diag([2.0, 3, 4, 1, 2, 3])
        start = np.array([0.5, 0.2, 0.1])
        times = np.linspace(0.001, 2, 2000)
        path = exact_motion.torque_free(times, inertia, np.zeros(3), start,
                                        np.array([0.3, 1.5, 0.2]))
        velocity = np.gradient(path.position[0], times, axis=0)
        inverse_turn = path.attitude[0] * np.array([1.0, -1, -1, -1])
        momentum = rotated(path.attitude[0],
                           rotated(inverse_turn, velocity) * np.array([2.0, 3, 4]))
        # Central differences in time are in error by 1e-6.
        np.testing.assert_allclose(momentum[1:-1] - [1.0, 0.6, 0.4], 0, atol=2e-5)


class CostOfARun(unittest.TestCase):
    """100 steps of 0.1 ms, 1 ms of setting up and, for the process, 20 ms of starting."""

    def setUp(self):
        self.start_up = Cost(wall=1.1e-3, processor=21.1e-3)

    def test_is_that_of_the_steps_without_setting_up(self):
        cost = Cost(wall=11e-3, processor=31e-3)
        self.assertAlmostEqual(cost.seconds_of(100, self.start_up), 10e-3, delta=1e-12)

    def test_of_a_long_run_does_not_count_the_time_of_other_programs(self):
        cost = Cost(wall=55e-3, processor=31e-3)
        self.assertAlmostEqual(cost.seconds_of(100, self.start_up), 10e-3, delta=1e-12)

    def test_of_a_short_run_does_not_count_the_start_of_the_process(self):
        cost = Cost(wall=11e-3, processor=25e-3)  # It started faster than the other.
        self.assertAlmostEqual(cost.seconds_of(100, self.start_up), 10e-3, delta=1e-12)

    def test_is_not_nothing_where_the_process_started_much_faster_than_the_other(self):
        cost = Cost(wall=12.1e-3, processor=21.2e-3)
        self.assertGreater(cost.seconds_of(100, self.start_up), 10e-3)


class Rotations(unittest.TestCase):
    def test_vectors_and_quaternions_are_inverse(self):
        random = np.random.default_rng(3)
        vectors = random.normal(size=(100, 3))
        vectors *= (np.pi * random.uniform(size=100) / np.linalg.norm(vectors, axis=1))[:, None]
        vectors[0] = 0
        np.testing.assert_allclose(rotation_vector(from_rotation_vector(vectors)), vectors,
                                   atol=1e-14)


def finding_of(errors: dict, seconds: dict) -> Finding:
    """Runs whose error and time follow from their rate, by method."""
    rows = [Row("heave", "time", method, None, rate, 80, rate, False, error(rate), None, None,
                seconds[method](rate))
            for method, error in errors.items() for rate in (15 * 2**i for i in range(9))]
    return Finding(next(e for e in kExperiments if e.name == "heave"), rows=rows)


class Judgement(unittest.TestCase):
    """A plain method of error 1/rate against one of 4/rate² that costs twice as much a step."""

    def setUp(self):
        self.finding = finding_of(
            {"baseline": lambda rate: 1 / rate, "default": lambda rate: 4 / rate**2},
            {"baseline": lambda rate: 1e-3 * rate, "default": lambda rate: 2e-3 * rate})

    def test_orders_are_the_slopes(self):
        for method, order in (("baseline", 1), ("default", 2)):
            self.assertAlmostEqual(judgement.order_of(self.finding, method), order, delta=1e-12)

    def test_ratios_are_those_of_the_power_laws(self):
        judged = judgement.judge(self.finding, "default")
        # The plain method needs a rate of 1000, 1 s; ours then takes 500, in error by 1.6e-5, and
        # is at 1e-3 with a rate of sqrt(4000), in 2e-3 of that.
        self.assertAlmostEqual(judged.baseline_seconds, 1, delta=1e-12)
        self.assertAlmostEqual(judged.error_ratio.value, 62.5, delta=1e-9)
        self.assertAlmostEqual(judged.speed_ratio.value, 500 / np.sqrt(4000), delta=1e-9)
        self.assertFalse(judged.error_ratio.at_least or judged.speed_ratio.at_least)

    def test_errors_below_the_references_own_count_as_bounds(self):
        self.finding.doubt = 1e-5
        judged = judgement.judge(self.finding, "default")
        self.assertTrue(judged.error_ratio.at_least)
        self.assertAlmostEqual(judged.error_ratio.value, 10, delta=1e-9)

    def test_a_lucky_run_does_not_count(self):
        lucky = finding_of(
            {"baseline": lambda rate: 1e-9 if rate == 60 else 1 / rate},
            {"baseline": lambda rate: 1e-3 * rate})
        self.assertAlmostEqual(judgement.target_of(lucky)[1], 1, delta=1e-12)

    def test_a_plain_method_that_stays_above_is_met_at_its_best(self):
        poor = finding_of({"baseline": lambda rate: 30 / rate, "default": lambda rate: 1 / rate**2},
                          {"baseline": lambda rate: rate, "default": lambda rate: rate})
        target, seconds = judgement.target_of(poor)
        self.assertAlmostEqual(target, 30 / 3840, delta=1e-12)
        self.assertAlmostEqual(seconds, 3840, delta=1e-9)

    def test_runs_that_are_all_better_are_compared_at_their_own_error(self):
        good = finding_of({"baseline": lambda rate: 1 / rate, "default": lambda rate: 1e-2 / rate},
                          {"baseline": lambda rate: rate, "default": lambda rate: rate})
        ratio = judgement.judge(good, "default").speed_ratio
        self.assertFalse(ratio.at_least)
        self.assertAlmostEqual(ratio.value, 1500 / 15, delta=1e-9)

    def test_runs_better_than_the_plain_method_ever_is_give_bounds(self):
        good = finding_of({"baseline": lambda rate: 1 / rate, "default": lambda rate: 1e-3 / rate},
                          {"baseline": lambda rate: rate, "default": lambda rate: rate})
        ratio = judgement.judge(good, "default").speed_ratio
        self.assertTrue(ratio.at_least)
        self.assertAlmostEqual(ratio.value, 1000 / 15, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
