#include "engine/machines/machines.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/engine/rig_specs.h"
#include "tests/support/random_pose.h"

namespace {

using Eigen::Vector3d;
using engine::Simulation;
using engine::SimulationSpec;

/// A box deep in water with a screw of 2 m that drives it along x, at 3 1/s.
SimulationSpec with_screw() {
  SimulationSpec spec =
      support::dry_world({support::box_body("hull", {10, 3, 3}, 1000, {0, 0, -20})}, 1.0 / 60);
  spec.sea = hydro::Sea{.density = 1025};
  engine::PropellerSpec screw{.name = "main", .body = 0, .at_B = {-6, 0.5, -1}};
  screw.screw.diameter = 2;
  screw.speed = support::add_set_point(spec, "propellers[main].speed_rps", 3);
  screw.azimuth = support::add_set_point(spec, "propellers[main].azimuth_deg", 0);
  spec.propellers = {screw};
  return spec;
}

engine::FoilSpec rudder(SimulationSpec& spec, double angle) {
  engine::FoilSpec foil{.name = "rudder", .body = 0, .at_B = {-8, 0, -1}};
  foil.foil.span = 2;
  foil.foil.chord = 1.5;
  foil.angle = support::add_set_point(spec, "rudders[rudder].angle_deg", angle);
  return foil;
}

TEST(Propeller, PushesAtTheBollardWithItsTabulatedForceAndTurnsItsHullBack) {
  const SimulationSpec spec = with_screw();
  const engine::SetPoints points(spec);
  const engine::Machines machines(spec, points);
  support::Random random(3);
  hydro::BodyState state = spec.bodies[0].initial;
  state.orientation = random.rotation();
  const hydro::Wrench load = machines.load(0, state, 0);
  const Vector3d axis = state.orientation * Vector3d::UnitX();
  const Vector3d arm = state.orientation * spec.propellers[0].at_B;
  EXPECT_NEAR((load.force - 67.12e3 * axis).norm(), 0, 10);
  EXPECT_NEAR((load.moment - arm.cross(load.force) + 19.94e3 * axis).norm(), 0, 10);
}

TEST(Propeller, FeelsTheCurrentAndWavesOfItsPlace) {
  SimulationSpec spec = with_screw();
  const engine::SetPoints points(spec);
  hydro::BodyState state = spec.bodies[0].initial;
  const double bollard = engine::Machines(spec, points).load(0, state, 0).force.x();
  state.linear_velocity = {2, 0, 0};
  const double sailing = engine::Machines(spec, points).load(0, state, 0).force.x();
  spec.sea->current = {2, 0, 0};
  EXPECT_NEAR(engine::Machines(spec, points).load(0, state, 0).force.x(), bollard, 1e-9 * bollard);
  spec.sea->current = {-2, 0, 0};
  state.linear_velocity.setZero();
  EXPECT_NEAR(engine::Machines(spec, points).load(0, state, 0).force.x(), sailing, 1e-9 * sailing);
  EXPECT_LT(sailing, 0.8 * bollard);
}

TEST(Propeller, PushesLessAsItComesOutOfTheWater) {
  const SimulationSpec spec = with_screw();
  const engine::SetPoints points(spec);
  const engine::Machines machines(spec, points);
  hydro::BodyState state = spec.bodies[0].initial;
  const double whole = machines.load(0, state, 0).force.norm();
  state.position.z() = 1;  // the disc's centre is in the surface
  EXPECT_NEAR(machines.load(0, state, 0).force.norm(), whole / 2, 1e-9 * whole);
  state.position.z() = 2.01;
  EXPECT_EQ(machines.load(0, state, 0).force.norm(), 0);
}

TEST(Propeller, TurnsItsThrustWithItsAzimuth) {
  SimulationSpec spec = with_screw();
  spec.set_points[1].initial = std::numbers::pi / 2;
  const engine::SetPoints points(spec);
  const Vector3d force = engine::Machines(spec, points).load(0, spec.bodies[0].initial, 0).force;
  EXPECT_NEAR((force - 67.12e3 * Vector3d::UnitY()).norm(), 0, 10);
}

TEST(Propeller, DrivesABodyToTheSpeedAtWhichItPushesNoMore) {
  SimulationSpec spec = with_screw();
  spec.gravity = 0;
  spec.propellers[0].at_B = {0, 0, 0};
  spec.bodies[0].locked = {false, true, true, true, true, true};
  Simulation simulation(std::move(spec));
  for (int i = 0; i < 60 * 200; ++i) simulation.step();
  const auto screw = simulation.rig().propellers[0];
  EXPECT_NEAR(screw.thrust, 0, 700);  // 1 % of the bollard pull
  EXPECT_NEAR(screw.advance, simulation.states()[0].linear_velocity.x() / 6, 1e-6);
  EXPECT_NEAR(screw.turn, 2 * std::numbers::pi * 3 * 200, 1e-6);
}

TEST(Rudder, OfAPositiveAngleTurnsTheShipToPort) {
  SimulationSpec spec = with_screw();
  spec.foils = {rudder(spec, 0.3)};
  spec.set_points[0].initial = 0;
  spec.bodies[0].initial.linear_velocity = {4, 0, 0};
  const engine::SetPoints points(spec);
  const hydro::Wrench load = engine::Machines(spec, points).load(0, spec.bodies[0].initial, 0);
  EXPECT_LT(load.force.y(), -1e3);
  EXPECT_GT(load.moment.z(), 1e4);
  EXPECT_LT(load.force.x(), 0);
}

TEST(Rudder, SteersInTheRaceOfAScrewAtRest) {
  SimulationSpec spec = with_screw();
  spec.foils = {rudder(spec, 0.3)};
  const engine::SetPoints points(spec);
  const engine::Machines alone(spec, points);
  EXPECT_NEAR(alone.foil(0, spec.bodies[0].initial, 0).force_W.norm(), 0, 1e-9);
  spec.foils[0].behind = 0;
  const engine::FoilReading raced =
      engine::Machines(spec, points).foil(0, spec.bodies[0].initial, 0);
  EXPECT_LT(raced.force_W.y(), -3e3);
  EXPECT_GT(raced.speed, 3);
}

TEST(Sail, TakesTheWindAboveTheWaterAlone) {
  SimulationSpec spec = with_screw();
  spec.propellers.clear();
  spec.sea->air = hydro::Air{.density = 1.2, .wind = {.velocity = {0, 10, 0}}};
  engine::FoilSpec sail = rudder(spec, 0);
  sail.fluid = engine::FoilSpec::Fluid::air;
  sail.at_B = {0, 0, 25};
  spec.foils = {sail};
  const engine::SetPoints points(spec);
  const engine::Machines machines(spec, points);
  hydro::BodyState state = spec.bodies[0].initial;
  // Across the wind a plate has the force C_N ½ρU²A with C_N about 1.2.
  EXPECT_NEAR(machines.load(0, state, 0).force.y(), 1.2 * 0.6 * 100 * 3, 40);
  state.position.z() = -30;
  EXPECT_EQ(machines.load(0, state, 0).force.norm(), 0);
}

}  // namespace
