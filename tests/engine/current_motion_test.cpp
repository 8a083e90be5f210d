#include "engine/motion/energy.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/engine/prelude.h"

/// Bodies in a current that changes with depth.

namespace {

using engine::BodyForces;
using hydro::Sea;

Sea sheared_sea() {
  Sea sea{.density = 1000, .gravity = kGravity, .current = {1.5, 0.2, 0}};
  sea.profile = {{0, {1.5, 0.2}}, {4, {1, -0.4}}, {12, {0, 0}}};
  return sea;
}

/// A neutrally buoyant spheroid with the added mass of one, three times as long as wide.
BodySpec slender_body(const Vector3d& position) {
  BodySpec body = support::sphere_body("spheroid", 0.5, 1000, position);
  body.mesh_B.vertices.row(0) *= 3;
  body.mass = 1000 * hydro::solid_properties(body.mesh_B).volume;
  body.inertia_B = body.mass * Vector3d(0.1, 0.5, 0.5).asDiagonal();
  body.initial.orientation = Quaterniond(Eigen::AngleAxisd(0.6, Vector3d::UnitZ()));
  Vector6d diagonal;
  diagonal << 0.12, 0.81, 0.81, 1e-3, 0.3, 0.3;
  body.added_mass = std::make_shared<hydro::ConstantAddedMass>(
      body.mesh_B, Matrix6d((1000 * diagonal).asDiagonal()));
  body.wet = true;
  body.coefficients.lift = 0;
  return body;
}

BodySpec without_friction_or_pressure(BodySpec body) {
  body.coefficients.pressure_drag = {0, 0};
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  return body;
}

SimulationSpec in_sheared_sea(BodySpec body, const Sea& sea) {
  SimulationSpec spec = support::dry_world({std::move(body)}, kStep);
  spec.sea = sea;
  spec.record_work = true;
  return spec;
}

TEST(ShearedCurrent, TakesABodyAlongAtTheVelocityOfItsDepth) {
  for (const double depth : {2.0, 8.0}) {
    BodySpec body = support::sphere_body("ball", 0.1, 1000, {0, 0, -depth});
    body.wet = true;
    body.locked = {false, false, true, true, true, true};
    const Simulation end = support::after(in_sheared_sea(body, sheared_sea()), 12000);
    const Vector3d v = end.states()[0].linear_velocity;
    const Vector3d u = hydro::current_at(sheared_sea(), -depth);
    // It is approached as 1/t, with 1 % left after 120 s.
    EXPECT_LT((v - u).norm(), 0.02 * u.norm()) << depth;
  }
}

/// The Munk moment of a flow of 1.5 m/s would give it 1 rad/s within a second.
TEST(ShearedCurrent, LeavesABodyInStillWaterBelowItAtRest) {
  const BodySpec body = without_friction_or_pressure(slender_body({0, 0, -20}));
  const Simulation end = support::after(in_sheared_sea(body, sheared_sea()), 500);
  EXPECT_LT(end.states()[0].angular_velocity.norm(), tolerance(1e-9));
  EXPECT_LT(end.states()[0].linear_velocity.norm(), tolerance(1e-9));
}

/// Where the current has one velocity all is as in that current, turning included.
TEST(ShearedCurrent, IsAUniformCurrentToABodyBelowIt) {
  Sea sheared = sheared_sea();
  for (hydro::CurrentRow& row : sheared.profile) row.velocity += Eigen::Vector2d(0.7, 0.3);
  sheared.current += Vector3d(0.7, 0.3, 0);
  Sea uniform = sheared;
  uniform.profile.clear();
  uniform.current = {0.7, 0.3, 0};
  BodySpec body = slender_body({0, 0, -30});
  body.initial.linear_velocity = {0.2, -0.1, 0};
  body.initial.angular_velocity = {0.1, 0.05, 0.3};
  const Simulation a = support::after(in_sheared_sea(body, sheared), 500);
  const Simulation b = support::after(in_sheared_sea(body, uniform), 500);
  EXPECT_LT(distance(a.states()[0], b.states()[0]), tolerance(1e-9));
}

TEST(ShearedCurrent, HasNoGuardOfStillWater) {
  const SimulationSpec spec = in_sheared_sea(slender_body({0, 0, -3}), sheared_sea());
  EXPECT_FALSE(engine::must_not_gain_energy(engine::make_bodies(spec)[0]));
}

TEST(ShearedCurrent, ClosesTheBudgetOfWorks) {
  BodySpec body = slender_body({0, 0, -3});
  body.mass *= 1.01;  // It sinks through the layers.
  const SimulationSpec spec = in_sheared_sea(body, sheared_sea());
  const BodyForces start = Simulation(spec).forces()[0];
  const BodyForces end = support::after(spec, 1500).forces()[0];
  const double all = std::abs(end.works.pressure_drag) + std::abs(end.works.added_mass);
  EXPECT_GT(std::abs(end.works.added_mass), 1e-3 * all);
  EXPECT_NEAR(end.kinetic_energy - start.kinetic_energy, end.works.sum(), 1e-3 * all);
}

}  // namespace
