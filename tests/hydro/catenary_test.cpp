#include "hydro/lines/catenary.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector2d;
using hydro::CatenaryLine;
using hydro::CatenarySolution;
using hydro::solve_catenary;
using Form = CatenarySolution::Form;

/// x and z that belong to the tensions, by the textbook forms of (1) and (2) in long double.
Vector2d textbook(const CatenaryLine& line, const CatenarySolution& s, bool bottom) {
  const long double h = s.horizontal, v = s.vertical, w = line.weight, ea = line.stiffness;
  const long double length = line.length, low = v - w * length;
  if (bottom && low < 0) {
    const long double rests = length - v / w, c = line.friction * w;
    const long double free = c > 0 ? std::max(rests - h / c, 0.0L) : 0;
    const long double x = rests + h / w * std::asinh(v / h) + h * length / ea +
                          c / (2 * ea) * (-rests * rests + (c > 0 ? (rests - h / c) * free : 0));
    const long double z = h / w * (std::sqrt(1 + v / h * v / h) - 1) + v * v / (2 * ea * w);
    return Vector2d(static_cast<double>(x), static_cast<double>(z));
  }
  const long double x = h / w * (std::asinh(v / h) - std::asinh(low / h)) + h * length / ea;
  const long double z =
      (std::hypot(h, v) - std::hypot(h, low)) / w + (v * length - w * length * length / 2) / ea;
  return Vector2d(static_cast<double>(x), static_cast<double>(z));
}

struct LineCase {
  CatenaryLine line;
  double x = 0, z = 0;
  bool bottom = false;

  CatenarySolution solve() const { return solve_catenary(line, x, z, bottom); }
  CatenarySolution solve(double dx, double dz) const {
    return solve_catenary(line, x + dx, z + dz, bottom);
  }
};

/// Lines of every form: chains and ropes, up to 40 % longer or shorter than their chord.
LineCase random_case(support::Random& random) {
  LineCase c;
  const auto power = [&](double low, double high) {
    return std::pow(10, random.uniform(low, high));
  };
  c.line.length = power(0, 3);
  c.line.weight = power(-1, 4);
  c.line.stiffness = c.line.weight * c.line.length * power(0, 4);
  c.bottom = random.uniform(0, 1) < 0.6;
  c.line.friction = c.bottom && random.uniform(0, 1) < 0.5 ? random.uniform(0, 2) : 0;
  const double angle = random.uniform(c.bottom ? 0.01 : -1.5, 1.5);
  const double chord = c.line.length * random.uniform(0.6, 1.4);
  c.x = chord * std::cos(angle);
  c.z = chord * std::sin(angle);
  return c;
}

TEST(Catenary, AgreesWithMoorPy) {
  // MoorPy iterates to 1e-6, and its tests state what it gets: tensions to 6e-7 of the exact ones.
  constexpr double kTheirs = 1e-6;
  const auto expect = [](const LineCase& c, double anchor_h, double anchor_v, double h, double v) {
    const CatenarySolution s = c.solve();
    EXPECT_NEAR(s.horizontal, h, support::tolerance(kTheirs) * h);
    EXPECT_NEAR(s.vertical, v, support::tolerance(kTheirs) * v);
    EXPECT_NEAR(s.anchor_horizontal, anchor_h, support::tolerance(kTheirs) * h);
    EXPECT_NEAR(s.anchor_vertical, anchor_v, support::tolerance(kTheirs) * v);
  };
  CatenaryLine line{500, 800, 7.51e12, 0};
  expect({line, 400, 200, true}, 96643.428, 0, 96643.428, 237751.755);
  EXPECT_NEAR((LineCase{line, 400, 200, true}.solve().resting), 202.810306, 2e-5);
  line.friction = 0.1;
  expect({line, 400, 200, true}, 80418.604, 0, 96643.429, 237751.756);
  line.friction = 5;
  expect({line, 400, 200, true}, 0, 0, 96643.435, 237751.760);
  expect({{500, 200, 7.51e12}, 400, 200}, 43694.581, -22365.599, 43694.581, 77634.401);
  expect({{130, 881.05, 7.51e8}, 89.9, 59.2}, 31373.229, -26650.341, 31373.229, 87886.159);
}

TEST(Catenary, NearlyTautAgreesWithMoorPyWithinTheDigitsOfItsEnds) {
  const LineCase c{{130.36140, 34.91, 7e8}, 119.32374, 52.49669};
  // Ends and length are given to 5e-6 m, which the stretch of the line multiplies by its stiffness.
  const double digits = 1e-5 * c.line.stiffness / c.line.length;
  EXPECT_NEAR(c.solve().horizontal, 72694.1, digits);
  EXPECT_NEAR(c.solve().vertical, 34266.2, digits);
}

TEST(Catenary, FulfilsTheTextbookEquations) {
  support::Random random(1);
  int on_bottom = 0, taut = 0;
  for (int i = 0; i < 10000; ++i) {
    const LineCase c = random_case(random);
    const CatenarySolution s = c.solve();
    if (s.form == Form::slack) continue;
    on_bottom += s.form == Form::on_bottom;
    taut += s.form == Form::taut;
    const Vector2d miss = textbook(c.line, s, c.bottom) - Vector2d(c.x, c.z);
    // Tensions have a relative error of 1e-16, which is 1e-16 of the stretch; so has x.
    ASSERT_LT(miss.norm(), support::tolerance(1e-12) * c.line.length) << "line " << i;
  }
  EXPECT_GT(on_bottom, 1000);
  EXPECT_GT(taut, 1000);
}

TEST(Catenary, DoesNotDependOnItsStart) {
  support::Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const LineCase c = random_case(random);
    const CatenarySolution cold = c.solve();
    const double factor = std::pow(10, random.uniform(-3, 3));
    const Vector2d start(cold.horizontal * factor, cold.vertical * random.uniform(-2, 2));
    const CatenarySolution warm = solve_catenary(c.line, c.x, c.z, c.bottom, start);
    const Vector2d change(warm.horizontal - cold.horizontal, warm.vertical - cold.vertical);
    // What the last digits of x and z do to the tensions: 1e-15 L times the stiffness.
    const double round_off = 1e-15 * c.line.length * cold.stiffness.norm();
    ASSERT_LT(change.norm(), support::tolerance(1e-12) * cold.tension() + 10 * round_off);
  }
  const LineCase c{{500, 800, 7.51e8, 0.1}, 400, 200, true};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vector2d& useless : {Vector2d(0, 0), Vector2d(-1, 5), Vector2d(nan, 1)})
    EXPECT_EQ(solve_catenary(c.line, c.x, c.z, true, useless).horizontal, c.solve().horizontal);
}

TEST(Catenary, StiffnessIsTheDerivativeOfTheTensions) {
  support::Random random(3);
  int checked = 0;
  for (int i = 0; i < 3000; ++i) {
    LineCase c = random_case(random);
    c.line.friction = 0;
    const CatenarySolution s = c.solve();
    const double d = 1e-5 * c.line.length;
    const CatenarySolution east = c.solve(d, 0), west = c.solve(-d, 0);
    const CatenarySolution up = c.solve(0, d), down = c.solve(0, -d);
    Eigen::Matrix2d k;
    k << east.horizontal - west.horizontal, up.horizontal - down.horizontal,
        east.vertical - west.vertical, up.vertical - down.vertical;
    k /= 2 * d;
    if (east.resting * west.resting == 0 && east.resting + west.resting > 0) continue;
    if ((up.form == Form::slack) != (west.form == Form::slack)) continue;
    // The curvature of the tensions, from the derivatives on both sides, bounds the error of k.
    const double bend = (east.stiffness - 2 * s.stiffness + west.stiffness).norm() +
                        (up.stiffness - 2 * s.stiffness + down.stiffness).norm();
    ASSERT_LT((k - s.stiffness).norm(), support::tolerance(1e-6) * s.stiffness.norm() + bend)
        << "line " << i << ", form " << static_cast<int>(s.form);
    checked += bend < 1e-4 * s.stiffness.norm();
  }
  EXPECT_GT(checked, 2000);
}

TEST(Catenary, StiffnessIsSymmetricAndNeverNegative) {
  support::Random random(4);
  for (int i = 0; i < 10000; ++i) {
    const Eigen::Matrix2d k = random_case(random).solve().stiffness;
    EXPECT_EQ(k(0, 1), k(1, 0));
    const Eigen::Vector2d values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(k).eigenvalues();
    ASSERT_GE(values[0], -support::tolerance(1e-12) * values[1]);
  }
}

TEST(Catenary, ChangesItsFormWithoutAJump) {
  const CatenaryLine line{100, 50, 1e6, 0.3};
  const auto expect_steady = [&](const Vector2d& from, const Vector2d& to, double step) {
    const int count = static_cast<int>((to - from).norm() / step);
    CatenarySolution last = solve_catenary(line, from[0], from[1], true);
    for (int i = 1; i <= count; ++i) {
      const Vector2d p = from + (to - from) * i / count;
      const CatenarySolution s = solve_catenary(line, p[0], p[1], true);
      // Friction and √z near the bottom aside, the tensions change as the stiffness says.
      const double most = 1.1 * step * (s.stiffness + last.stiffness).norm() + 1e-9;
      ASSERT_LT(std::hypot(s.horizontal - last.horizontal, s.vertical - last.vertical), most)
          << p.transpose();
      last = s;
    }
  };
  expect_steady({10, 40}, {120, 40}, 0.01);  // slack, on the bottom, suspended, taut
  expect_steady({0, 20}, {0, 150}, 0.01);    // slack, taut, both vertical
  expect_steady({60, 0.5}, {60, 90}, 0.01);  // slack, on the bottom, suspended, taut
  expect_steady({99.9, 1e-3}, {100.1, 1e-3}, 1e-5);
}

TEST(Catenary, ReachesItsLimitsFromEitherSide) {
  const CatenaryLine line{100, 50, 1e6, 0.3};
  // The slope √z of V at the bottom: 1e-12 m high, V is 1e-6 of its scale.
  EXPECT_NEAR(solve_catenary(line, 101, 1e-12, true).horizontal,
              solve_catenary(line, 101, 0, true).horizontal, 1e-3);
  EXPECT_EQ(solve_catenary(line, 101, -3, true).horizontal,
            solve_catenary(line, 101, 0, true).horizontal);
  for (const double z : {-150.0, -40.0, 40.0, 150.0}) {
    const CatenarySolution at = solve_catenary(line, 0, z, false);
    const CatenarySolution near = solve_catenary(line, 1e-10, z, false);
    EXPECT_NEAR(at.vertical, near.vertical, 1e-6);
    EXPECT_NEAR(at.horizontal, near.horizontal, 1e-6);
  }
  // A light line is a spring, at last.
  for (const double z : {10.0, -60.0}) {
    const CatenarySolution spring = solve_catenary({100, 0, 1e6}, 130, z, false);
    const CatenarySolution light = solve_catenary({100, 1e-9, 1e6}, 130, z, false);
    EXPECT_NEAR(spring.horizontal, 1e6 * (1 / 100.0 - 1 / std::hypot(130, z)) * 130, 1e-6);
    EXPECT_NEAR(spring.horizontal, light.horizontal, 1e-6);
    EXPECT_NEAR(spring.vertical, light.vertical, 1e-6);
    EXPECT_LT((spring.stiffness - light.stiffness).norm(), 1e-6 * spring.stiffness.norm());
  }
  EXPECT_EQ(solve_catenary({100, 0, 1e6}, 60, 70, false).tension(), 0);
}

TEST(Catenary, SlackHangsStraightDownWithItsOwnWeight) {
  const CatenarySolution s = solve_catenary({100, 50, 1e12, 0.3}, 30, 40, true);
  EXPECT_EQ(s.form, Form::slack);
  EXPECT_EQ(s.horizontal, 0);
  EXPECT_NEAR(s.vertical, 50 * 40, 1e-4);
  EXPECT_NEAR(s.resting, 60, 1e-5);
}

TEST(Catenary, DoesNoWorkOnAClosedPath) {
  const CatenaryLine line{100, 50, 1e5, 0};
  const int count = 20000;  // The midpoint rule on a smooth period, but for kinks of second order.
  double work = 0, amount = 0;
  for (int i = 0; i < count; ++i) {
    const double phase = 2 * M_PI * (i + 0.5) / count;
    const CatenarySolution s =
        solve_catenary(line, 90 + 15 * std::cos(phase), 45 + 30 * std::sin(phase), true);
    const double part = -15 * std::sin(phase) * s.horizontal + 30 * std::cos(phase) * s.vertical;
    work += part;
    amount += std::abs(part);
  }
  EXPECT_LT(std::abs(work), support::tolerance(1e-9) * amount);
}

TEST(Catenary, ShapeHasTheLengthAndTheEndsOfTheLine) {
  support::Random random(5);
  for (int i = 0; i < 300; ++i) {
    LineCase c = random_case(random);
    c.line.stiffness *= 1e9;
    if (std::hypot(c.x, c.z) > 0.98 * c.line.length) continue;
    const CatenarySolution s = c.solve();
    if (s.form == Form::slack) continue;
    const int count = 2001;
    const std::vector<Vector2d> points = hydro::catenary_shape(c.line, s, c.x, c.z, count);
    double length = 0;
    for (int j = 1; j < count; ++j) length += (points[j] - points[j - 1]).norm();
    // A chord of an arc is shorter by (ds/R)²/24; the tightest bend has R = H/w.
    EXPECT_NEAR(length, c.line.length, support::tolerance(1e-3) * c.line.length) << i;
    EXPECT_EQ(points.front(), Vector2d::Zero());
    EXPECT_EQ(points.back(), Vector2d(c.x, c.z));
    EXPECT_LT((points[count - 2] - points.back()).norm(), 1.001 * c.line.length / (count - 1));
  }
}

TEST(Catenary, ShapeEndsWhereTheLineIsPulledAlsoIfItStretches) {
  support::Random random(6);
  for (int i = 0; i < 1000; ++i) {
    const LineCase c = random_case(random);
    const CatenarySolution s = c.solve();
    const std::vector<Vector2d> points = hydro::catenary_shape(c.line, s, c.x, c.z, 1001);
    const double tension = std::max(s.tension(), std::hypot(s.horizontal, s.anchor_vertical));
    const double longest = (1 + tension / c.line.stiffness) * c.line.length / 1000;
    for (int j = 1; j <= 1000; ++j) {
      if (s.form == Form::slack && points[j].y() == 0) continue;
      ASSERT_LT((points[j] - points[j - 1]).norm(), 1.0001 * longest) << i;
    }
  }
}

TEST(Catenary, IsFiniteWhateverTheLine) {
  support::Random random(7);
  const auto power = [&](double most) { return std::pow(10, random.uniform(-most, most)); };
  for (int i = 0; i < 50000; ++i) {
    CatenaryLine line{power(4), power(6), power(15), power(2)};
    if (i % 7 == 0) line.friction = 0;
    if (i % 11 == 0) line.weight = 0;
    const double x = i % 5 == 0 ? 0 : line.length * power(i % 2 == 0 ? 12 : 0.3);
    const double z = i % 3 == 0 ? 0 : line.length * power(i % 4 == 0 ? 12 : 0.3);
    for (const bool bottom : {true, false}) {
      const CatenarySolution s = solve_catenary(line, x, i % 9 == 0 ? -z : z, bottom);
      ASSERT_TRUE(std::isfinite(s.tension()) && s.stiffness.allFinite()) << i;
      ASSERT_GE(s.horizontal, 0);
      ASSERT_GE(s.resting, 0);
      ASSERT_LE(s.resting, line.length);
    }
  }
}

TEST(Catenary, RefusesWhatIsNoLine) {
  EXPECT_THROW(solve_catenary({0, 1, 1}, 1, 1, true), std::invalid_argument);
  EXPECT_THROW(solve_catenary({1, -1, 1}, 1, 1, true), std::invalid_argument);
  EXPECT_THROW(solve_catenary({1, 1, 0}, 1, 1, true), std::invalid_argument);
  EXPECT_THROW(solve_catenary({1, 1, 1, -1}, 1, 1, true), std::invalid_argument);
  EXPECT_THROW(solve_catenary({1, 1, 1}, -1, 1, true), std::invalid_argument);
  EXPECT_THROW(solve_catenary({1, 1, 1}, 1, std::nan(""), true), std::invalid_argument);
}

}  // namespace
