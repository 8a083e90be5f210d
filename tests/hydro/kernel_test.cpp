#include <gtest/gtest.h>

#include <algorithm>

#include "hydro/airy_waves.h"
#include "hydro/loads/loads.h"
#include "hydro/loads/plain_loads.h"
#include "hydro/loads/refine.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/random_pose.h"
#include "tests/support/reference_loads.h"
#include "tests/support/repeats.h"
#include "tests/support/tolerance.h"

/// The kernel against the plain sum over the panels.

namespace {

using hydro::BodyState;
using hydro::Coefficients;
using hydro::Hull;
using hydro::Loads;
using hydro::Sea;
using hydro::ViscousDrag;
using hydro::Wrench;

/// Hulls of all kinds of panels: few and large, many, slivers, round, thin.
std::vector<Hull> hulls(support::Random& random) {
  std::vector<Hull> all;
  all.push_back(hydro::make_hull(hydro::make_box({2, 3, 1})));
  all.push_back(hydro::make_hull(hydro::make_box({2, 1, 0.02}, 8)));
  all.push_back(hydro::make_hull(hydro::make_icosphere(1, 5)));
  all.push_back(hydro::make_hull(hydro::make_cylinder(0.2, 12, 24, 30)));
  all.push_back(hydro::make_hull(support::random_star(random, 4)));
  return all;
}

/// Most often cut by the surface, sometimes above or below it.
BodyState state_near_surface(const Hull& hull, support::Random& random) {
  return random.state(0.8 * hull.radius, 2);
}

/// The largest force among the loads [N].
double scale_of(const Loads& loads) {
  return std::max({loads.buoyancy.force.norm(), loads.pressure_drag.force.norm(),
                   loads.lift.force.norm(), loads.viscous_drag.force.norm()});
}

void expect_near(const Wrench& a, const Wrench& b, double error, double radius) {
  EXPECT_LE((a.force - b.force).norm(), error);
  EXPECT_LE((a.moment - b.moment).norm(), error * std::max(radius, 1.0));
}

/// The kernel's promise: 1e-12 of the largest force.
constexpr double kExact = 1e-12;

/// Viscous drag is a quadrature: 1e-5 of its largest component is promised.
constexpr double kViscous = 1e-5;

void expect_same(const Loads& a, const Loads& b, double radius) {
  const double error = support::tolerance(kExact) * scale_of(b);
  expect_near(a.buoyancy, b.buoyancy, error, radius);
  expect_near(a.pressure_drag, b.pressure_drag, error, radius);
  expect_near(a.lift, b.lift, error, radius);
  expect_near(a.viscous_drag, b.viscous_drag,
              support::tolerance(kViscous) * support::largest(b.viscous_drag) + error, radius);
  EXPECT_NEAR(a.wetted_area, b.wetted_area, support::tolerance(1e-12) * radius * radius * 4 * M_PI);
  EXPECT_NEAR(a.displaced_volume, b.displaced_volume,
              support::tolerance(1e-12) * radius * radius * radius * 4);
}

TEST(Kernel, AgreesWithThePlainSumInAnyPoseAndMotion) {
  support::Random random(51);
  const Sea sea{.density = 1025, .gravity = 9.81, .current = {0.3, -0.1, 0.2}};
  for (const Hull& hull : hulls(random)) {
    for (int i = 0; i < support::repeats(20); ++i) {
      const BodyState state = state_near_surface(hull, random);
      Coefficients coefficients{.lift = 0.4};
      if (i % 2 == 0) coefficients.drag_shape = random.drag_shape();
      const Loads plain = hydro::plain_loads(hull, state, sea, 0, coefficients);
      expect_same(hydro::compute_loads(hull, state, sea, 0, coefficients), plain, hull.radius);
      expect_same(hydro::compute_loads(hull, state, sea, 0, coefficients, {.branches = false}),
                  plain, hull.radius);
    }
  }
}

TEST(Kernel, AgreesWithThePlainSumForEveryLawOfViscousDrag) {
  support::Random random(52);
  const ViscousDrag laws[] = {
      {ViscousDrag::Law::constant, 0.02},
      {ViscousDrag::Law::thesis},
      {.law = ViscousDrag::Law::ittc57, .length = 2, .reynolds_per_speed = 2e6},
      // Re = 1e4 at 1 m/s: the line is held on a part of the body.
      {.law = ViscousDrag::Law::ittc57, .length = 0.01, .reynolds_per_speed = 1e4},
      {.law = ViscousDrag::Law::ittc57, .reynolds_per_speed = 0},  // It is held everywhere.
  };
  for (const Hull& hull : hulls(random)) {
    for (const ViscousDrag& law : laws) {
      for (int i = 0; i < support::repeats(4); ++i) {
        BodyState state = state_near_surface(hull, random);
        if (i % 2 == 0) state.linear_velocity *= 3;
        const Coefficients coefficients{.viscous_drag = law};
        const Wrench ours = hydro::compute_loads(hull, state, {}, 0, coefficients).viscous_drag;
        const Wrench plain = hydro::plain_loads(hull, state, {}, 0, coefficients).viscous_drag;
        // Of a body that is hardly wet the round-off of its corners counts, too.
        const double error = support::tolerance(kViscous) * support::largest(plain) + 1e-12;
        expect_near(ours, plain, error, hull.radius);
      }
    }
  }
}

TEST(Kernel, FindsNoViscousDragWhereTheCoefficientIsZero) {
  const Hull hull = hydro::make_hull(hydro::make_box({2, 3, 1}, 32));
  // On no face is the tangential speed below 2 m/s, though the normal one is as large.
  BodyState state{.position = {0, 0, -5}, .linear_velocity = {2.1, 2, -2.2}};
  const Coefficients thesis = hydro::thesis_coefficients();
  EXPECT_EQ(support::largest(hydro::compute_loads(hull, state, {}, 0, thesis).viscous_drag), 0);
  state.linear_velocity *= 0.6;
  EXPECT_GT(support::largest(hydro::compute_loads(hull, state, {}, 0, thesis).viscous_drag), 0);
}

enum class Waves { airy, airy_on_a_bottom, hydrostatic, grid };
constexpr Waves kAllWaves[] = {Waves::airy, Waves::airy_on_a_bottom, Waves::hydrostatic,
                               Waves::grid};

Sea wavy(Waves waves) {
  Sea sea{.density = 1025, .current = {0.2, -0.1, 0}};
  if (waves == Waves::airy_on_a_bottom) sea.depth = 4;
  if (waves != Waves::grid) {
    sea.surface = hydro::WaveSurface{
        {hydro::linear_wave(sea, 0.3, 0.52, 0.4, 1), hydro::linear_wave(sea, 0.1, 0.9, -1.1, 2)},
        waves == Waves::hydrostatic ? hydro::Kinematics::hydrostatic : hydro::Kinematics::airy};
    return sea;
  }
  Eigen::MatrixXd heights(64, 80);
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 80; ++column)
      heights(row, column) = 0.3 * std::cos(0.13 * column) + 0.1 * std::cos(0.2 * row + 1);
  sea.surface = hydro::make_height_field(heights, 0.25, {-10, -8});
  return sea;
}

TEST(Kernel, AgreesWithThePlainSumInWaves) {
  support::Random random(53);
  for (const Waves waves : kAllWaves) {
    const Sea sea = wavy(waves);
    for (const Hull& hull : hulls(random)) {
      for (int i = 0; i < support::repeats(8); ++i) {
        const BodyState state = state_near_surface(hull, random);
        SCOPED_TRACE(testing::Message()
                     << hull.mesh_B.face_count() << " faces, waves " << static_cast<int>(waves));
        const Coefficients slender{.lift = 0.01, .drag_shape = random.drag_shape()};
        const Loads plain = hydro::plain_loads(hull, state, sea, 1.5, slender);
        if (hull.mesh_B.face_count() == 12) {
          // Its faces are split, where of two equally long edges roundings choose the one: both
          // ways are within the tolerance of the splitting.
          const Loads ours =
              hydro::compute_loads(hull, state, sea, 1.5, slender, {.branches = false});
          const double error = support::tolerance(hydro::kSagTolerance) * scale_of(plain);
          expect_near(ours.buoyancy, plain.buoyancy, error, hull.radius);
          expect_near(ours.pressure_drag, plain.pressure_drag, error, hull.radius);
          continue;
        }
        expect_same(hydro::compute_loads(hull, state, sea, 1.5, slender, {.branches = false}),
                    plain, hull.radius);
      }
    }
  }
}

/// The waves bend over its faces, of which none may be taken for dry.
TEST(Kernel, KeepsTheLargeFacesOfASubmergedBodyInWaves) {
  const Hull box = hydro::make_hull(hydro::make_box({6, 6, 2}));
  for (const Waves waves : kAllWaves) {
    const Sea sea = wavy(waves);
    for (const double z : {-4.8, -6.0, -9.0}) {
      SCOPED_TRACE(testing::Message() << "waves " << static_cast<int>(waves) << ", z " << z);
      const BodyState deep{.position = {0.3, -0.2, z}, .linear_velocity = {1, 0.5, 0}};
      const Loads ours = hydro::compute_loads(box, deep, sea, 1, {}, {.branches = false});
      const Loads plain = hydro::plain_loads(box, deep, sea, 1, {});
      const double error = support::tolerance(hydro::kSagTolerance);
      EXPECT_NEAR(ours.displaced_volume, 72, error * 72);
      expect_near(ours.buoyancy, plain.buoyancy, error * scale_of(plain), box.radius);
      expect_near(ours.pressure_drag, plain.pressure_drag, error * scale_of(plain), box.radius);
    }
  }
}

/// A swell is quadratic over the whole sphere, at rest, so that the motion into the water changes
/// its sign on more faces than wait at a time.
TEST(Kernel, TakesALargeBranchInALongSwellHoweverManyFacesItsMotionTurnsOn) {
  const Hull hull = hydro::make_hull(hydro::make_icosphere(1, 6));
  Sea sea{.density = 1000};
  sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.5, 900, 0.3, 0.2, sea.gravity)}};
  const BodyState state{.position = {3, -2, -8},
                        .orientation = Eigen::Quaterniond(0.6, 0.3, -0.5, 0.5).normalized()};
  const hydro::Coefficients coefficients{.viscous_drag = {hydro::ViscousDrag::Law::none}};
  const Loads fast = hydro::compute_loads(hull, state, sea, 0.7, coefficients);
  const Loads plain = hydro::plain_loads(hull, state, sea, 0.7, coefficients);
  const double error = 1e-4 * plain.pressure_drag.force.norm();
  EXPECT_GT(plain.pressure_drag.force.norm(), 0);
  expect_near(fast.pressure_drag, plain.pressure_drag, error, hull.radius);
}

TEST(Kernel, TakesBranchesInWavesWithinTheTolerance) {
  support::Random random(54);
  for (const Waves waves : kAllWaves) {
    const Sea sea = wavy(waves);
    for (const Hull& hull : hulls(random)) {
      const double buoyancy =
          sea.density * sea.gravity * hydro::solid_properties(hull.mesh_B).volume;
      for (int i = 0; i < support::repeats(8); ++i) {
        const BodyState state = state_near_surface(hull, random);
        const Coefficients slender{.lift = 0.01, .drag_shape = random.drag_shape()};
        for (const double wanted : {1e-2, 1e-4, 1e-6}) {
          SCOPED_TRACE(wanted);
          const Loads each = hydro::compute_loads(hull, state, sea, 1.5, slender,
                                                  {.branches = false, .wave_tolerance = wanted});
          const Loads whole =
              hydro::compute_loads(hull, state, sea, 1.5, slender, {.wave_tolerance = wanted});
          EXPECT_LT((whole.buoyancy.force - each.buoyancy.force).norm(),
                    support::tolerance(wanted) * buoyancy);
          EXPECT_LT((whole.buoyancy.moment - each.buoyancy.moment).norm(),
                    support::tolerance(wanted) * buoyancy * hull.radius);
          // Under Airy waves the motion of the water, too, is constant over a branch.
          const bool airy = hydro::has_airy_waves(sea);
          const double error = airy ? support::tolerance(wanted) * buoyancy
                                    : support::tolerance(kExact) * scale_of(each);
          expect_near(whole.pressure_drag, each.pressure_drag, error, hull.radius);
          expect_near(whole.lift, each.lift, error, hull.radius);
          expect_near(whole.viscous_drag, each.viscous_drag,
                      error + support::tolerance(kViscous) * scale_of(each), hull.radius);
          EXPECT_NEAR(whole.displaced_volume, each.displaced_volume,
                      support::tolerance(wanted) * buoyancy / (sea.density * sea.gravity) + 1e-12);
        }
      }
    }
  }
}

TEST(Kernel, AgreesWithThePlainSumOverLinesAndEdgesOfGrids) {
  support::Random random(55);
  const Hull hull = hydro::make_hull(hydro::make_icosphere(1, 5));
  for (const auto& [rows, columns] : {std::pair{3, 4}, std::pair{1, 4}, std::pair{5, 1}}) {
    Sea sea;
    Eigen::MatrixXd heights(rows, columns);
    // As uneven as it may be so that no face is split.
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        heights(row, column) = 0.2 * (row + column) + random.uniform(-0.01, 0.01);
    sea.surface = hydro::make_height_field(heights, 0.5, {-0.7, -0.6});
    for (int i = 0; i < support::repeats(10); ++i) {
      SCOPED_TRACE(testing::Message() << rows << " x " << columns << ", pose " << i);
      const BodyState state = state_near_surface(hull, random);
      const Loads plain = hydro::plain_loads(hull, state, sea, 0, {});
      expect_same(hydro::compute_loads(hull, state, sea, 0, {}, {.wave_tolerance = 0}), plain,
                  hull.radius);
    }
  }
}

/// Under h = a + b x + c y + d x y the depth h − z has the gradient (b + d y, c + d x, −1): by the
/// divergence theorem its mean over a body is that at the centroid.
TEST(Kernel, TakesBranchesUnderOneCellOfAGridExactly) {
  support::Random random(56);
  const Hull hull = hydro::make_hull(hydro::make_icosphere(1, 4));
  const double volume = hydro::solid_properties(hull.mesh_B).volume;
  Sea sea;
  Eigen::Matrix2d heights;
  heights << 0.2, -0.1, 0.3, 0.4;
  const double cell = 8;
  sea.surface = hydro::make_height_field(heights, cell, {-4, -4});
  const double twist = (heights(0, 0) + heights(1, 1) - heights(0, 1) - heights(1, 0)) / cell;
  for (int i = 0; i < support::repeats(10); ++i) {
    BodyState state{.orientation = random.rotation()};
    state.position = random.vector(2) - Eigen::Vector3d(0, 0, 4);
    const Eigen::Vector2d place = (state.position.head<2>() + Eigen::Vector2d(4, 4)) / cell;
    const double along_x = (heights(0, 1) - heights(0, 0) + twist * cell * place.y()) / cell;
    const double along_y = (heights(1, 0) - heights(0, 0) + twist * cell * place.x()) / cell;
    const Eigen::Vector3d wanted =
        sea.density * sea.gravity * volume * Eigen::Vector3d(-along_x, -along_y, 1);
    const Eigen::Vector3d force = hydro::compute_loads(hull, state, sea, 0, {}).buoyancy.force;
    EXPECT_LT((force - wanted).norm(), support::tolerance(1e-12) * wanted.norm());
  }
}

TEST(Kernel, HasNoDragAtSpeedsWhoseSquareIsNoProperNumber) {
  const Hull hull = hydro::make_hull(hydro::make_icosphere(1, 2));
  BodyState state{.linear_velocity = {1e-160, 0, 0}};
  const Loads loads = hydro::compute_loads(hull, state, {}, 0, {});
  EXPECT_EQ(support::largest(loads.pressure_drag), 0);
  EXPECT_EQ(support::largest(loads.viscous_drag), 0);
  EXPECT_GT(support::largest(loads.buoyancy), 0);
}

TEST(Kernel, LeavesOutFacesWithoutArea) {
  hydro::TriMesh mesh = hydro::make_box({1, 1, 1}, 2);
  const Loads before = hydro::compute_loads(hydro::make_hull(mesh), {}, {}, 0, {});
  mesh.faces.conservativeResize(3, mesh.face_count() + 1);
  mesh.faces.rightCols(1) << 0, 0, 1;
  const Loads after = hydro::compute_loads(hydro::make_hull(mesh), {}, {}, 0, {});
  EXPECT_EQ(after.buoyancy.force, before.buoyancy.force);
  EXPECT_EQ(after.wetted_area, before.wetted_area);
}

}  // namespace
