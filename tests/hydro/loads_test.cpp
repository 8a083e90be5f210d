#include "hydro/loads/loads.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "hydro/airy_waves.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/random_pose.h"
#include "tests/support/reference_loads.h"
#include "tests/support/repeats.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::BodyState;
using hydro::Coefficients;
using hydro::Hull;
using hydro::Loads;
using hydro::Sea;
using hydro::ViscousDrag;
using hydro::Wrench;

const Sea kStillSea{.density = 1025, .gravity = 9.81, .level = 0.3};

/// The mesh about its centroid, as a hull's must be for a body of uniform density.
Hull centred_hull(const hydro::TriMesh& mesh) {
  return hydro::make_hull(hydro::translated(mesh, -hydro::solid_properties(mesh).centroid));
}

/// A state near the surface, most often cut by it.
BodyState state_near_surface(support::Random& random) {
  BodyState state = random.state(0.8, 2);
  state.position.x() *= 100;
  state.position.z() += kStillSea.level;
  return state;
}

void expect_close(const Wrench& ours, const Wrench& exact, double relative, double scale) {
  EXPECT_LT(support::largest(ours + -1.0 * exact), support::tolerance(relative) * scale);
}

void expect_same(const Loads& a, const Loads& b) {
  EXPECT_EQ(a.total().force, b.total().force);
  EXPECT_EQ(a.total().moment, b.total().moment);
  EXPECT_EQ(a.wetted_area, b.wetted_area);
  EXPECT_EQ(a.displaced_volume, b.displaced_volume);
}

TEST(Loads, AgreeWithExactIntegrationOnRandomMeshesInRandomPoses) {
  support::Random random(21);
  for (int i = 0; i < support::repeats(12); ++i) {
    const Hull hull = centred_hull(support::random_star(random, 1));
    const BodyState state = state_near_surface(random);
    Sea sea = kStillSea;
    sea.current = random.vector(0.5);
    const Coefficients coefficients{.lift = 0.4, .drag_shape = random.drag_shape()};
    const Loads ours = hydro::compute_loads(hull, state, sea, 0, coefficients);
    const Loads exact = support::reference_loads(hull.mesh_B, state, sea, coefficients, 24);
    expect_close(ours.buoyancy, exact.buoyancy, 1e-10, support::largest(exact.buoyancy));
    expect_close(ours.pressure_drag, exact.pressure_drag, 1e-10,
                 support::largest(exact.pressure_drag));
    expect_close(ours.lift, exact.lift, 1e-10, support::largest(exact.lift));
    expect_close(ours.viscous_drag, exact.viscous_drag, 1e-5, support::largest(exact.viscous_drag));
    EXPECT_NEAR(ours.wetted_area, exact.wetted_area, 1e-11);
    EXPECT_NEAR(ours.displaced_volume, exact.displaced_volume, 1e-11);
  }
}

TEST(Loads, WhollySubmergedObeyArchimedes) {
  support::Random random(22);
  for (int i = 0; i < 20; ++i) {
    const hydro::TriMesh mesh = support::random_star(random);
    const auto solid = hydro::solid_properties(mesh);
    BodyState state = random.state(50, 0);
    state.position.z() = -random.uniform(10, 5000);
    const Loads loads = hydro::compute_loads(hydro::make_hull(mesh), state, kStillSea, 0, {});
    const Vector3d weight(0, 0, kStillSea.density * kStillSea.gravity * solid.volume);
    const Vector3d arm = state.orientation * solid.centroid;
    // Depths of 5,000 m must not cost digits: 1e-13 of the force, as at the surface.
    EXPECT_LT((loads.buoyancy.force - weight).norm(), support::tolerance(1e-13) * weight.z());
    EXPECT_LT((loads.buoyancy.moment - arm.cross(weight)).norm(),
              support::tolerance(1e-13) * weight.z());
    EXPECT_NEAR(loads.displaced_volume, solid.volume, support::tolerance(1e-13) * solid.volume);
  }
}

TEST(Loads, InStillWaterHaveNoHorizontalForceAndNoVerticalTorqueInAnyPose) {
  support::Random random(23);
  const Hull hulls[] = {
      hydro::make_hull(hydro::make_box({2, 3, 1})),
      hydro::make_hull(hydro::make_box({20, 8, 3}, 8)),
      hydro::make_hull(hydro::make_sphere(1, 50, 50)),
      hydro::make_hull(hydro::translated(support::random_star(random), {0.3, -0.2, 0.1})),
      hydro::make_hull(hydro::make_cylinder(0.2, 12, 24, 30)),
  };
  for (const Hull& hull : hulls) {
    const double weight =
        kStillSea.density * kStillSea.gravity * hydro::solid_properties(hull.mesh_B).volume;
    for (int i = 0; i < 60; ++i) {
      BodyState state{.orientation = random.rotation()};
      state.position = random.vector(1.5 * hull.radius);
      if (i % 7 == 0) state.position.z() *= 1000;
      if (i % 5 == 0) state.position.x() += 1e6;
      const Wrench b = hydro::compute_loads(hull, state, kStillSea, 0, {}).buoyancy;
      EXPECT_LT(b.force.head<2>().norm(), support::tolerance(1e-13) * weight);
      EXPECT_LT(std::abs(b.moment.z()), support::tolerance(1e-13) * weight * hull.radius);
    }
  }
}

TEST(Loads, DoNotChangeWhenTheMeshIsSplit) {
  support::Random random(24);
  const BodyState state = state_near_surface(random);
  const Loads coarse = hydro::compute_loads(hydro::make_hull(hydro::make_box({1, 2, 1.5})), state,
                                            kStillSea, 0, {.lift = 0.3});
  const Loads fine = hydro::compute_loads(hydro::make_hull(hydro::make_box({1, 2, 1.5}, 16)), state,
                                          kStillSea, 0, {.lift = 0.3});
  expect_close(fine.buoyancy, coarse.buoyancy, 1e-12, support::largest(coarse.buoyancy));
  expect_close(fine.pressure_drag, coarse.pressure_drag, 1e-12,
               support::largest(coarse.pressure_drag));
  expect_close(fine.lift, coarse.lift, 1e-12, support::largest(coarse.lift));
  expect_close(fine.viscous_drag, coarse.viscous_drag, 1e-5, support::largest(coarse.viscous_drag));
}

TEST(Loads, DoNotDependOnTheHorizontalPositionInStillWater) {
  support::Random random(25);
  const Hull hull = centred_hull(support::random_star(random));
  BodyState state = state_near_surface(random);
  const Loads here = hydro::compute_loads(hull, state, kStillSea, 0, {});
  state.position.x() += 1e6;
  state.position.y() -= 3e7;
  expect_same(hydro::compute_loads(hull, state, kStillSea, 5, {}), here);
}

TEST(Loads, OfABodyCarriedByTheCurrentHaveNoDrag) {
  support::Random random(26);
  BodyState state = state_near_surface(random);
  state.angular_velocity.setZero();
  Sea sea = kStillSea;
  sea.current = state.linear_velocity;
  const Loads loads =
      hydro::compute_loads(centred_hull(support::random_star(random)), state, sea, 0, {});
  EXPECT_EQ(support::largest(loads.pressure_drag), 0);
  EXPECT_EQ(support::largest(loads.viscous_drag), 0);
  EXPECT_EQ(support::largest(loads.lift), 0);
  EXPECT_GT(support::largest(loads.buoyancy), 0);
}

TEST(Loads, OfDragTakeEnergyOutOfEveryMotion) {
  support::Random random(27);
  const Hull hull = centred_hull(support::random_star(random));
  for (int i = 0; i < 50; ++i) {
    const BodyState state = state_near_surface(random);
    const Loads loads = hydro::compute_loads(hull, state, kStillSea, 0, {});
    if (loads.wetted_area == 0) continue;
    for (const Wrench& drag : {loads.pressure_drag, loads.viscous_drag})
      EXPECT_LE(drag.force.dot(state.linear_velocity) + drag.moment.dot(state.angular_velocity), 0);
    EXPECT_LT(loads.pressure_drag.force.dot(state.linear_velocity) +
                  loads.pressure_drag.moment.dot(state.angular_velocity),
              0);
  }
}

TEST(Loads, AboveTheHighestWaterAreZero) {
  const Hull hull = hydro::make_hull(hydro::make_box({1, 1, 1}));
  const BodyState state{.position = {0, 0, kStillSea.level + 0.5}, .linear_velocity = {1, 2, 3}};
  const Loads loads = hydro::compute_loads(hull, state, kStillSea, 0, {});
  EXPECT_EQ(support::largest(loads.total()), 0);
  EXPECT_EQ(loads.wetted_area, 0);
}

TEST(Loads, ThatAreSwitchedOffAreZeroAndLeaveTheOthersAsTheyWere) {
  support::Random random(28);
  const Hull hull = centred_hull(support::random_star(random));
  const BodyState state = state_near_surface(random);
  const Loads all = hydro::compute_loads(hull, state, kStillSea, 0, {});
  const Loads none = hydro::compute_loads(hull, state, kStillSea, 0,
                                          {.buoyancy = false,
                                           .pressure_drag = {0, 0},
                                           .lift = 0,
                                           .viscous_drag = {ViscousDrag::Law::none}});
  EXPECT_EQ(support::largest(none.total()), 0);
  EXPECT_DOUBLE_EQ(none.displaced_volume,
                   all.displaced_volume);  // Whole branches sum in another order.
  const Loads drag_only = hydro::compute_loads(
      hull, state, kStillSea, 0,
      {.buoyancy = false, .lift = 0, .viscous_drag = {ViscousDrag::Law::none}});
  EXPECT_EQ(drag_only.total().force, all.pressure_drag.force);
}

TEST(Loads, InASeaSlopingAsAPlaneAreTiltedByItsSlope) {
  support::Random random(29);
  const double sx = 0.13, sy = -0.07;
  Eigen::MatrixXd heights(60, 50);
  for (int row = 0; row < 60; ++row)
    for (int column = 0; column < 50; ++column) heights(row, column) = sx * column + sy * row;
  Sea sea = kStillSea;
  sea.surface = hydro::make_height_field(heights, 1, {-25, -30});
  for (int i = 0; i < 10; ++i) {
    const Hull hull = centred_hull(support::random_star(random));
    BodyState state = random.state(3, 0);
    state.position.z() = -10;
    const double weight = sea.density * sea.gravity * hydro::solid_properties(hull.mesh_B).volume;
    const Wrench b = hydro::compute_loads(hull, state, sea, 0, {}).buoyancy;
    // Elevations of some metres on a body of one metre cost a digit.
    EXPECT_LT((b.force - weight * Vector3d(-sx, -sy, 1)).norm(),
              support::tolerance(1e-12) * weight);
    EXPECT_LT(b.moment.norm(), support::tolerance(1e-12) * weight);
  }
}

TEST(Loads, OnAFixedBoxInAWaveAreTheFroudeKrylovForce) {
  // The heave force beyond the static one is ρ g A a e^{−kT} sin(kL/2)/(kL/2) cos ωt at the draught
  // T, for small waves; with hydrostatic pressure it does not decay.
  const Vector3d size(10, 4, 3);
  const Hull hull = hydro::make_hull(hydro::make_box(size));
  const double amplitude = 1e-4, draught = size.z() / 2 + 0.2;
  for (const auto kinematics : {hydro::Kinematics::airy, hydro::Kinematics::hydrostatic}) {
    for (const double wavelength : {60.0, 20.0, 12.0, 7.0, 4.0}) {
      SCOPED_TRACE(wavelength);
      Sea sea = kStillSea;
      sea.level = 0;
      sea.surface = hydro::WaveSurface{
          {hydro::deep_water_wave(amplitude, wavelength, 0, 0, sea.gravity)}, kinematics};
      const BodyState state{.position = {0, 0, -0.2}};
      const double still = sea.density * sea.gravity * size.x() * size.y() * draught;
      const double unit = sea.density * sea.gravity * size.x() * size.y() * amplitude;
      const double half_phase = M_PI * size.x() / wavelength;
      const double decay =
          kinematics == hydro::Kinematics::airy ? std::exp(-2 * M_PI * draught / wavelength) : 1;
      const double force = hydro::compute_loads(hull, state, sea, 0, {}).buoyancy.force.z() - still;
      EXPECT_NEAR(force / unit, decay * std::sin(half_phase) / half_phase,
                  support::tolerance(0.7 * 5e-3));
    }
  }
}

TEST(Loads, InShortWavesConvergeToThoseOfAFineMesh) {
  support::Random random(30);
  Sea sea = kStillSea;
  sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.2, 3, 0.4, 1, 9.81),
                                    hydro::deep_water_wave(0.1, 2, -1.1, 2, 9.81)}};
  for (int i = 0; i < support::repeats(5); ++i) {
    BodyState state = random.state(1, 1);
    const Loads coarse =
        hydro::compute_loads(hydro::make_hull(hydro::make_box({6, 4, 2})), state, sea, 1.5, {});
    const Loads fine = hydro::compute_loads(hydro::make_hull(hydro::make_box({6, 4, 2}, 128)),
                                            state, sea, 1.5, {});
    const double wave = sea.density * sea.gravity * 24 * 0.3;
    expect_close(coarse.buoyancy, fine.buoyancy, 5e-3, wave);
    // Drag is within the tolerance of the submerged box's buoyancy, moments of that at its radius.
    const double radius = hydro::make_hull(hydro::make_box({6, 4, 2})).radius;
    expect_close(coarse.pressure_drag, fine.pressure_drag, hydro::LoadAccuracy{}.wave_tolerance,
                 sea.density * sea.gravity * 48 * radius);
  }
}

}  // namespace
