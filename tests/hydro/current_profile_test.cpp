#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hydro/airy_waves.h"
#include "hydro/loads/load_jacobian.h"
#include "hydro/loads/loads.h"
#include "hydro/loads/plain_loads.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

/// Loads of a current that changes with depth.

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using hydro::BodyState;
using hydro::Coefficients;
using hydro::CurrentRow;
using hydro::Hull;
using hydro::Loads;
using hydro::Sea;
using hydro::ViscousDrag;
using hydro::Wrench;

Sea sea_with(std::vector<CurrentRow> profile) {
  Sea sea{.density = 1025, .gravity = 9.81, .level = 0.4, .profile = std::move(profile)};
  sea.current << sea.profile.front().velocity, 0;
  return sea;
}

/// Layers of shear that turns, one of still water, and a jump.
std::vector<CurrentRow> some_profile() {
  return {{0.1, {1.2, 0.1}}, {0.5, {0.6, -0.3}}, {0.51, {0.1, 0.2}},
          {0.9, {0.1, 0.2}}, {1.6, {-0.5, 0.4}}, {4.0, {0, 0}}};
}

/// A wave on that water, which an observer at rest sees.
Sea with_waves(Sea sea, double depth = std::numeric_limits<double>::infinity()) {
  sea.depth = depth;
  sea.surface = hydro::WaveSurface{
      {hydro::linear_wave(sea, 0.12, 0.7, 0.4, 1), hydro::linear_wave(sea, 0.05, 1.1, -1.1, 2)}};
  return sea;
}

double largest_force(const Loads& loads) {
  return std::max({loads.buoyancy.force.norm(), loads.pressure_drag.force.norm(),
                   loads.viscous_drag.force.norm()});
}

/// @param exact   Error allowed over the largest force [-].
/// @param viscous   The same of viscous drag, a quadrature, over itself.
void expect_same_loads(const Loads& a, const Loads& b, double radius, double exact,
                       double viscous) {
  const double error = support::tolerance(exact) * largest_force(b);
  const auto near = [&](const Wrench& one, const Wrench& other, double allowed) {
    EXPECT_LE((one.force - other.force).norm(), allowed);
    EXPECT_LE((one.moment - other.moment).norm(), allowed * std::max(radius, 1.0));
  };
  near(a.buoyancy, b.buoyancy, error);
  near(a.pressure_drag, b.pressure_drag, error);
  near(a.lift, b.lift, error);
  near(a.viscous_drag, b.viscous_drag,
       error + support::tolerance(viscous) * b.viscous_drag.force.norm());
  EXPECT_NEAR(a.displaced_volume, b.displaced_volume, support::tolerance(1e-11));
}

TEST(CurrentProfile, IsLinearBetweenItsRowsAndConstantBeyondThem) {
  const Sea sea = sea_with({{1, {2, 0}}, {3, {1, 4}}, {4, {0, 0}}});
  const auto at = [&](double depth) { return hydro::current_at(sea, sea.level - depth); };
  const double error = support::tolerance(1e-14);
  EXPECT_LE((at(-5) - Vector3d(2, 0, 0)).norm(), error);
  EXPECT_LE((at(0.5) - Vector3d(2, 0, 0)).norm(), error);
  EXPECT_LE((at(1.5) - Vector3d(1.75, 1, 0)).norm(), error);
  EXPECT_LE((at(3) - Vector3d(1, 4, 0)).norm(), error);
  EXPECT_LE((at(3.75) - Vector3d(0.25, 1, 0)).norm(), error);
  EXPECT_LE(at(400).norm(), error);
}

TEST(CurrentProfile, AddsToTheMotionOfWaves) {
  const Sea sheared = with_waves(sea_with(some_profile()));
  Sea uniform = sheared;
  uniform.profile.clear();
  support::Random random(71);
  for (int i = 0; i < 50; ++i) {
    const Vector3d p = random.vector(3);
    const hydro::WaterMotion a = hydro::water_at(sheared, p, 0.3 * i);
    const hydro::WaterMotion b = hydro::water_at(uniform, p, 0.3 * i);
    const Vector3d more = hydro::current_at(sheared, p.z()) - sheared.current;
    EXPECT_LE((a.velocity - b.velocity - more).norm(), support::tolerance(1e-14));
    EXPECT_EQ(a.acceleration, b.acceleration);
    EXPECT_EQ(a.head, b.head);
  }
}

/// ∫ ½ρ (C_front + C_back) u² b dz over layers from (z_i, u_i) to (z_i+1, u_i+1), and its moment
/// about z = 0.
TEST(CurrentProfile, DragsAPlateByTheSquareOfTheVelocityOnTheSpot) {
  const double breadth = 1.7, height = 5, front = 0.9, back = 0.2;
  const Sea sea = sea_with({{0.5, {1.5, 0}}, {1.1, {0.9, 0}}, {3.7, {0.3, 0}}, {4.2, {-0.2, 0}}});
  Coefficients coefficients{.pressure_drag = {front, back}, .lift = 0};
  coefficients.viscous_drag.law = ViscousDrag::Law::none;
  const Hull plate = hydro::make_hull(hydro::make_box({0.1, breadth, height}));
  const double low = sea.level - 4.9;  // The lowest row and the surface are on the plate.
  const BodyState state{.position = {3, 2, low + height / 2}};
  // The corners of u(z), the zero of u at 4 m among them: there both sides change their part.
  const double depths[] = {0, 0.5, 1.1, 3.7, 4, 4.2, 4.9};
  double force = 0, moment = 0;
  for (int i = 0; i < 6; ++i) {
    const double z1 = sea.level - depths[i], z0 = sea.level - depths[i + 1], h = z1 - z0;
    const double a = hydro::current_at(sea, z0).x(), b = hydro::current_at(sea, z1).x();
    const double sign = a + b > 0 ? 1 : -1;
    const double square = h / 3 * (a * a + a * b + b * b);
    const double first = h * h / 12 * (a * a + 2 * a * b + 3 * b * b);  // ∫ u² (z − z0) dz
    force += sign * square;
    moment += sign * (first + (z0 - state.position.z()) * square);
  }
  const double factor = 0.5 * sea.density * (front + back) * breadth;
  for (const bool branches : {true, false}) {
    const Loads loads =
        hydro::compute_loads(plate, state, sea, 0, coefficients, {.branches = branches});
    EXPECT_NEAR(loads.pressure_drag.force.x(), factor * force,
                support::tolerance(1e-12) * factor * force);
    EXPECT_NEAR(loads.pressure_drag.moment.y(), factor * moment,
                support::tolerance(1e-12) * factor * std::abs(moment));
    EXPECT_NEAR(loads.pressure_drag.force.tail<2>().norm(), 0,
                support::tolerance(1e-12) * factor * force);
    EXPECT_NEAR(loads.displaced_volume, 0.1 * breadth * 4.9, support::tolerance(1e-12));
  }
}

std::vector<Hull> hulls_in_current(support::Random& random) {
  std::vector<Hull> all;
  all.push_back(hydro::make_hull(hydro::make_box({2, 3, 1})));
  all.push_back(hydro::make_hull(hydro::make_box({2, 1, 0.02}, 8)));
  all.push_back(hydro::make_hull(hydro::make_icosphere(1, 4)));
  all.push_back(hydro::make_hull(support::random_star(random, 3)));
  return all;
}

TEST(CurrentProfile, OfOneVelocityIsAUniformCurrent) {
  support::Random random(72);
  const Vector2d U(0.7, -0.4);
  for (const bool waves : {false, true}) {
    Sea uniform = sea_with({{0, U}});
    uniform.profile.clear();
    if (waves) uniform = with_waves(uniform, 6);
    Sea sheared = uniform;  // With the same waves to an observer at rest.
    sheared.current = {0.1, 0.3, 0};
    sheared.profile = {{0.2, U}, {1, U}, {7, U}};
    for (const Hull& hull : hulls_in_current(random))
      for (int i = 0; i < 5; ++i) {
        const BodyState state = random.state(0.8 * hull.radius, 1);
        const Coefficients coefficients{.lift = 0.4, .drag_shape = random.drag_shape()};
        const Loads a =
            hydro::compute_loads(hull, state, sheared, 0.7, coefficients, {.branches = false});
        const Loads b =
            hydro::compute_loads(hull, state, uniform, 0.7, coefficients, {.branches = false});
        expect_same_loads(a, b, hull.radius, 1e-12, 1e-5);
      }
  }
}

/// Two equally long edges of a face may be split in either order, as roundings have it: of viscous
/// drag, which takes the mean of the water's velocity over a piece, the plain sum then has another
/// value. Other loads are exact on all pieces.
TEST(CurrentProfile, HasTheLoadsOfThePlainSum) {
  support::Random random(73);
  const Sea sea = sea_with(some_profile());
  for (const Hull& hull : hulls_in_current(random))
    for (int i = 0; i < 12; ++i) {
      const BodyState state = random.state(0.8 * hull.radius, 1);
      Coefficients coefficients{.lift = 0.4};
      if (i % 2 == 0) coefficients.drag_shape = random.drag_shape();
      const Loads plain = hydro::plain_loads(hull, state, sea, 0, coefficients);
      const double viscous = hull.mesh_B.face_count() == 12 ? 0.05 : 1e-3;
      SCOPED_TRACE(testing::Message() << hull.mesh_B.face_count() << " faces, pose " << i);
      expect_same_loads(
          hydro::compute_loads(hull, state, sea, 0, coefficients, {.branches = false}), plain,
          hull.radius, 1e-12, viscous);
      // Branches in one layer are taken by polynomials through samples, which add up roundings.
      expect_same_loads(hydro::compute_loads(hull, state, sea, 0, coefficients), plain, hull.radius,
                        1e-11, viscous);
    }
}

TEST(CurrentProfile, HasTheLoadsOfThePlainSumInWaves) {
  support::Random random(74);
  for (const double depth : {std::numeric_limits<double>::infinity(), 6.0}) {
    const Sea sea = with_waves(sea_with(some_profile()), depth);
    const Hull hull = hydro::make_hull(hydro::make_icosphere(1, 5));
    for (int i = 0; i < 8; ++i) {
      const BodyState state = random.state(0.8 * hull.radius, 1);
      const Coefficients coefficients{.lift = 0.4, .drag_shape = random.drag_shape()};
      const Loads plain = hydro::plain_loads(hull, state, sea, 0.4, coefficients);
      expect_same_loads(
          hydro::compute_loads(hull, state, sea, 0.4, coefficients, {.branches = false}), plain,
          hull.radius, 1e-12, 1e-4);
      // 1e-4 of the buoyancy is the default tolerance of branches.
      expect_same_loads(hydro::compute_loads(hull, state, sea, 0.4, coefficients), plain,
                        hull.radius, 1e-4, 1e-2);
    }
  }
}

TEST(CurrentProfile, LooksTheSameToOneWhoDrifts) {
  support::Random random(75);
  const Sea at_rest = sea_with(some_profile());
  const Vector2d U(0.9, -1.3);
  Sea moving = at_rest;
  moving.current.head<2>() += U;
  for (CurrentRow& row : moving.profile) row.velocity += U;
  for (const Hull& hull : hulls_in_current(random))
    for (int i = 0; i < 5; ++i) {
      BodyState state = random.state(0.8 * hull.radius, 1);
      const Loads a = hydro::compute_loads(hull, state, at_rest, 0, {});
      const hydro::LoadJacobian before = hydro::load_jacobian(hull, state, at_rest, 0, {});
      state.linear_velocity.head<2>() += U;
      expect_same_loads(hydro::compute_loads(hull, state, moving, 0, {}), a, hull.radius, 1e-11,
                        1e-5);
      const hydro::LoadJacobian after = hydro::load_jacobian(hull, state, moving, 0, {});
      EXPECT_LE((after.drag - before.drag).norm(),
                support::tolerance(1e-11) * before.drag.norm() + 1e-300);
    }
}

/// A body deep in a layer that moves at one velocity is in a uniform current, to the last digits
/// that its branches leave.
TEST(CurrentProfile, IsUniformToABodyBetweenRowsOfOneVelocity) {
  support::Random random(76);
  Sea sea = sea_with({{0, {3, 1}}, {10, {0.4, -0.2}}, {20, {0.4, -0.2}}, {30, {0, 5}}});
  Sea uniform{.density = sea.density, .gravity = sea.gravity, .level = sea.level};
  uniform.current = {0.4, -0.2, 0};
  const Hull hull = hydro::make_hull(hydro::make_icosphere(1, 4));
  BodyState state = random.state(0.8 * hull.radius, 1);
  state.position.z() = -14;
  expect_same_loads(hydro::compute_loads(hull, state, sea, 0, {}),
                    hydro::compute_loads(hull, state, uniform, 0, {}), hull.radius, 1e-11, 1e-5);
}

/// Where a table has more rows over a body than faces are cut at, the velocity is linear over
/// pieces of some rows: the error is that of a parabola's chords.
TEST(CurrentProfile, MayHaveManyRowsOverOneFace) {
  std::vector<CurrentRow> rows;
  double square = 0;
  const auto u = [](double depth) { return 1.5 - 0.06 * depth * depth; };
  for (int i = 0; i <= 100; ++i) rows.push_back({0.05 * i, {u(0.05 * i), 0}});
  for (int i = 0; i < 100; ++i) {
    const double a = rows[i].velocity.x(), b = rows[i + 1].velocity.x();
    square += 0.05 / 3 * (a * a + a * b + b * b);
  }
  const Sea sea = sea_with(rows);
  Coefficients coefficients{.pressure_drag = {1, 0}, .lift = 0};
  coefficients.viscous_drag.law = ViscousDrag::Law::none;
  const Hull plate = hydro::make_hull(hydro::make_box({0.1, 2, 5}));
  const Loads loads =
      hydro::compute_loads(plate, {.position = {0, 0, sea.level - 2.5}}, sea, 0, coefficients);
  const double expected = 0.5 * sea.density * 2 * square;
  EXPECT_NEAR(loads.pressure_drag.force.x(), expected, 0.02 * expected);
}

}  // namespace
