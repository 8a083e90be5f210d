#include "hydro/loads/panel_loads.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "hydro/loads/viscous_drag.h"
#include "tests/support/random_pose.h"
#include "tests/support/reference_loads.h"
#include "tests/support/repeats.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::Panel;
using hydro::Twist;
using hydro::ViscousDrag;
using hydro::Wrench;
using support::Vector3l;

// Closed forms differ from extended quadrature by the rounding of some dozen operations on numbers
// of the size of the result's terms.
constexpr double kClosedFormRounding = 1e-14;

struct MovingPanel {
  Panel panel;
  Vector3d normal;
  Twist motion;

  explicit MovingPanel(support::Random& random)
      : panel{random.vector(2), random.vector(2), random.vector(2)},
        normal(hydro::area_vector(panel).normalized()),
        motion{random.vector(3), random.vector(2)} {}

  support::Polygon polygon() const {
    return {panel[0].cast<long double>(), panel[1].cast<long double>(),
            panel[2].cast<long double>()};
  }
  Vector3l n() const { return normal.cast<long double>(); }
  Vector3l v(const Vector3l& r) const {
    return motion.linear.cast<long double>() + motion.angular.cast<long double>().cross(r);
  }
  Vector3l v_t(const Vector3l& r) const { return v(r) - v(r).dot(n()) * n(); }
  Vector3d normal_speeds() const {
    return {motion.at(panel[0]).dot(normal), motion.at(panel[1]).dot(normal),
            motion.at(panel[2]).dot(normal)};
  }
  double area() const { return hydro::area_vector(panel).norm(); }
};

/// Force and moment of a traction by quadrature.
Wrench quadrature(const support::Polygon& where, const std::function<Vector3l(const Vector3l&)>& t,
                  int splits = 1) {
  const auto moment = [&](const Vector3l& r) -> Vector3l { return r.cross(t(r)); };
  return {support::integrate(where, t, splits).cast<double>(),
          support::integrate(where, moment, splits).cast<double>()};
}

void expect_near(const Wrench& a, const Wrench& b, double tolerance) {
  EXPECT_LT((a.force - b.force).norm(), support::tolerance(tolerance));
  EXPECT_LT((a.moment - b.moment).norm(), support::tolerance(tolerance));
}

TEST(PressureLoad, MatchesQuadrature) {
  support::Random random(11);
  for (int i = 0; i < 100; ++i) {
    const MovingPanel c(random);
    const Vector3d gradient = random.vector(2);
    const double offset = random.uniform(-3, 3);
    Vector3d pressure;
    for (int k = 0; k < 3; ++k) pressure[k] = offset + gradient.dot(c.panel[k]);
    const auto traction = [&](const Vector3l& r) -> Vector3l {
      return -(offset + gradient.cast<long double>().dot(r)) * c.n();
    };
    expect_near(hydro::pressure_load(c.panel, pressure), quadrature(c.polygon(), traction),
                kClosedFormRounding * 100 * c.area());
  }
}

TEST(PressureLoad, DoesNotDependOnTheOrderOfTheVertices) {
  support::Random random(12);
  const MovingPanel c(random);
  const Vector3d p = random.vector(5);
  const Wrench turned =
      hydro::pressure_load({c.panel[1], c.panel[2], c.panel[0]}, {p[1], p[2], p[0]});
  expect_near(hydro::pressure_load(c.panel, p), turned, kClosedFormRounding * 100);
}

TEST(PressureLoad, OfAPanelWithoutAreaIsZero) {
  const Vector3d a(1, 2, 3);
  const Wrench load = hydro::pressure_load({a, a, Vector3d(2, 2, 2)}, {1, 2, 3});
  EXPECT_EQ(load.force, Vector3d::Zero());
  EXPECT_EQ(load.moment, Vector3d::Zero());
}

TEST(PressureDragLoad, MatchesQuadratureOnEachSideOfTheCut) {
  support::Random random(13);
  const double k = 3.7;
  for (int i = 0; i < 100; ++i) {
    const MovingPanel c(random);
    const Vector3d u = c.normal_speeds();
    Wrench load;
    for (const double sign : {1.0, -1.0})
      for (const hydro::PanelPart& part : hydro::positive_part(c.panel, sign * u))
        load += hydro::pressure_drag_load(part.panel, c.normal, part.value, sign, k);
    const auto u_at = [&](const Vector3l& r) { return c.v(r).dot(c.n()); };
    const auto traction = [&](const Vector3l& r) -> Vector3l {
      return -k * u_at(r) * std::abs(u_at(r)) * c.n();
    };
    Wrench expected = quadrature(support::clip(c.polygon(), u_at), traction);
    expected += quadrature(support::clip(c.polygon(), [&](const Vector3l& r) { return -u_at(r); }),
                           traction);
    expect_near(load, expected, kClosedFormRounding * 1000 * c.area());
  }
}

TEST(PressureDragLoad, NeverDoesPositiveWork) {
  support::Random random(14);
  for (int i = 0; i < 200; ++i) {
    const MovingPanel c(random);
    const Vector3d u = c.normal_speeds();
    for (const double sign : {1.0, -1.0})
      for (const hydro::PanelPart& part : hydro::positive_part(c.panel, sign * u)) {
        const Wrench load = hydro::pressure_drag_load(part.panel, c.normal, part.value, sign, 1);
        EXPECT_LE(load.force.dot(c.motion.linear) + load.moment.dot(c.motion.angular), 1e-12);
      }
  }
}

TEST(LiftLoad, MatchesQuadratureOnASpinningPanel) {
  support::Random random(15);
  for (int i = 0; i < 100; ++i) {
    const MovingPanel c(random);
    const auto traction = [&](const Vector3l& r) -> Vector3l {
      return -2.5L * c.v_t(r).squaredNorm() * c.n();
    };
    Eigen::Matrix3d velocity;
    for (int k = 0; k < 3; ++k) velocity.col(k) = c.motion.at(c.panel[static_cast<std::size_t>(k)]);
    expect_near(hydro::lift_load(c.panel, c.normal, velocity, 2.5),
                quadrature(c.polygon(), traction), kClosedFormRounding * 1000 * c.area());
  }
}

TEST(ViscousCoefficient, FollowsTheTableOfTheThesis) {
  const ViscousDrag law{.law = ViscousDrag::Law::thesis};
  EXPECT_DOUBLE_EQ(hydro::viscous_coefficient(law, 0.5), 0.1);
  EXPECT_DOUBLE_EQ(hydro::viscous_coefficient(law, 1), 0.1);
  EXPECT_DOUBLE_EQ(hydro::viscous_coefficient(law, 1.5), 0.05);
  EXPECT_NEAR(hydro::viscous_coefficient(law, 2), 0, 1e-17);
  EXPECT_EQ(hydro::viscous_coefficient(law, 7), 0);
}

/// The viscous load by brute force; its own error is below 1e-7 at 64 splits.
Wrench brute_viscous(const MovingPanel& c, const ViscousDrag& law, double half_density) {
  const auto traction = [&](const Vector3l& r) -> Vector3l {
    const Vector3l t = c.v_t(r);
    const long double speed = t.norm();
    return -half_density * hydro::viscous_coefficient(law, static_cast<double>(speed)) * speed * t;
  };
  return quadrature(c.polygon(), traction, 64);
}

void expect_viscous_matches(const MovingPanel& c, const ViscousDrag& law) {
  const Wrench load = hydro::viscous_drag_load(c.panel, c.normal, c.motion, law, 500);
  double fastest = 0;
  for (int i = 0; i < 3; ++i) {
    const Vector3d v = c.motion.at(c.panel[i]);
    fastest = std::max(fastest, (v - c.normal * c.normal.dot(v)).norm());
  }
  const double largest = 500 * c.area() * hydro::viscous_coefficient(law, 0) * fastest * fastest;
  const double arm = 2 * std::sqrt(3.0);
  const Wrench expected = brute_viscous(c, law, 500);
  EXPECT_LT((load.force - expected.force).norm(), support::tolerance(2e-6) * largest);
  EXPECT_LT((load.moment - expected.moment).norm(), support::tolerance(2e-6) * largest * arm);
}

TEST(ViscousCoefficient, FollowsTheIttcLineAndIsHeldBelowIt) {
  const ViscousDrag law{.law = ViscousDrag::Law::ittc57, .reynolds_per_speed = 1e6};
  EXPECT_DOUBLE_EQ(hydro::viscous_coefficient(law, 1), 0.075 / 16);   // Re = 1e6
  EXPECT_DOUBLE_EQ(hydro::viscous_coefficient(law, 10), 0.075 / 25);  // Re = 1e7
  EXPECT_DOUBLE_EQ(hydro::viscous_coefficient(law, 0.01), 0.075 / 4);
  EXPECT_DOUBLE_EQ(hydro::viscous_coefficient(law, 1e-9), 0.075 / 4);
}

TEST(ViscousDragLoad, MatchesBruteForceOnTheIttcLine) {
  support::Random random(20);
  for (const double reynolds_per_speed : {1e4, 1e6}) {
    for (int i = 0; i < support::repeats(20); ++i)
      expect_viscous_matches(MovingPanel(random), {.law = ViscousDrag::Law::ittc57,
                                                   .reynolds_per_speed = reynolds_per_speed});
  }
}

TEST(ViscousDragLoad, MatchesBruteForceForAConstantCoefficient) {
  support::Random random(16);
  for (int i = 0; i < support::repeats(40); ++i)
    expect_viscous_matches(MovingPanel(random),
                           {.law = ViscousDrag::Law::constant, .coefficient = 0.3});
}

TEST(ViscousDragLoad, MatchesBruteForceAcrossTheKinksOfTheThesisLaw) {
  support::Random random(17);
  for (int i = 0; i < support::repeats(40); ++i) {
    MovingPanel c(random);
    c.motion.linear *= 0.5;
    c.motion.angular *= 0.5;
    expect_viscous_matches(c, {.law = ViscousDrag::Law::thesis});
  }
}

TEST(ViscousDragLoad, MatchesBruteForceWhereTheVelocityPassesThroughZero) {
  support::Random random(18);
  for (int i = 0; i < support::repeats(40); ++i) {
    MovingPanel c(random);
    const Vector3d inside = 0.2 * c.panel[0] + 0.5 * c.panel[1] + 0.3 * c.panel[2];
    c.motion.linear = -c.motion.angular.cross(inside);
    expect_viscous_matches(c, {.law = ViscousDrag::Law::constant, .coefficient = 1});
  }
}

TEST(ViscousDragLoad, OfAUniformVelocityIsExact) {
  support::Random random(19);
  MovingPanel c(random);
  c.motion.angular.setZero();
  const Vector3d v_t = c.motion.linear - c.normal * c.normal.dot(c.motion.linear);
  const Wrench load = hydro::viscous_drag_load(
      c.panel, c.normal, c.motion, {.law = ViscousDrag::Law::constant, .coefficient = 0.2}, 500);
  const Vector3d expected = -500 * 0.2 * c.area() * v_t.norm() * v_t;
  EXPECT_LT((load.force - expected).norm(), support::tolerance(1e-13) * expected.norm());
}

}  // namespace
