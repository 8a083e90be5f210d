#include "engine/machines/machines.h"

#include <gtest/gtest.h>

#include <numbers>

#include "hydro/added_mass/constant_added_mass.h"
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

/// A rod in space whose shaft spins so fast that the rod nutates by `turn` [rad] a step.
SimulationSpec with_flywheel(double turn) {
  SimulationSpec spec =
      support::dry_world({support::box_body("rod", {4, 1, 1}, 1000, {1, 2, 3})}, 1.0 / 60);
  spec.gravity = 0;
  engine::BodySpec& rod = spec.bodies[0];
  rod.initial.orientation = support::Random(5).rotation();
  rod.initial.angular_velocity = rod.initial.orientation * Vector3d(0, 0.5, 0);
  engine::PropellerSpec flywheel{.name = "flywheel", .body = 0, .inertia = 3};
  const double spin = turn / spec.step * rod.inertia_B(1, 1);
  flywheel.speed = support::add_set_point(spec, "propellers[flywheel].speed_rps",
                                          spin / (2 * std::numbers::pi * flywheel.inertia));
  flywheel.azimuth = support::add_set_point(spec, "propellers[flywheel].azimuth_deg", 0);
  spec.propellers = {flywheel};
  return spec;
}

/// Angular momentum of all bodies about the origin, with that of the flywheel on the first one.
Vector3d angular_momentum(const SimulationSpec& spec, const std::vector<hydro::BodyState>& states) {
  const engine::SetPoints points(spec);
  Vector3d sum = states[0].orientation * engine::Machines(spec, points).rotors_B(0, 0);
  for (std::size_t i = 0; i < states.size(); ++i)
    sum += support::spin(spec.bodies[i], states[i]) +
           spec.bodies[i].mass * states[i].position.cross(states[i].linear_velocity);
  return sum;
}

TEST(Flywheel, LetsItsBodyNutateWithoutGainOrLossHoweverFastItSpins) {
  for (const double turn : {0.01, 0.5, 5.0}) {
    SCOPED_TRACE(turn);
    SimulationSpec spec = with_flywheel(turn);
    // The added mass takes another way through the drift.
    for (const bool wet : {false, true}) {
      if (wet) {
        spec.sea = hydro::Sea{.density = 1e-30, .gravity = 0, .level = 100};  // no thrust
        hydro::Matrix6d A = hydro::Matrix6d::Zero();
        A.diagonal() << 0, 0, 0, 100, 900, 900;
        spec.bodies[0].added_mass =
            std::make_shared<hydro::ConstantAddedMass>(spec.bodies[0].mesh_B, A);
      }
      const double start = support::total_energy(spec, Simulation(spec).states());
      const hydro::BodyState end = support::after(spec, 600).states()[0];
      // (E2) is solved to round-off of the whole momentum, of which the body's own is a small part.
      EXPECT_NEAR(support::total_energy(spec, {end}) / start, 1, wet ? 1e-7 : 1e-9);
      if (wet) continue;
      const Vector3d momentum = angular_momentum(spec, {spec.bodies[0].initial});
      EXPECT_LT((angular_momentum(spec, {end}) - momentum).norm(), 1e-9 * momentum.norm());
    }
  }
}

// I ω' = −ω × H
TEST(Flywheel, LetsItsBodyNutateAtTheRateOfItsMomentumOverTheInertia) {
  const SimulationSpec spec = with_flywheel(0.5);
  const hydro::BodyState end = support::after(spec, 20).states()[0];
  const Vector3d rate = end.orientation.conjugate() * end.angular_velocity;
  // Parts of 0.1 rad have an error of 0.1²/12 of the phase.
  EXPECT_LT((rate - 0.5 * Vector3d(0, std::cos(10.0), std::sin(10.0))).norm(), 0.5 * 10 * 1e-3);
}

TEST(Flywheel, OnOneOfTwoBodiesOfAJointGivesThemNothing) {
  for (const auto type : {engine::JointSpec::Type::fixed, engine::JointSpec::Type::ball}) {
    SimulationSpec spec = with_flywheel(2);
    spec.bodies.push_back(support::box_body("weight", {1, 1, 1}, 1000, {1, 2, 5}));
    spec.bodies[1].initial.angular_velocity = spec.bodies[0].initial.angular_velocity;
    spec.bodies[1].initial.linear_velocity =
        spec.bodies[1].initial.angular_velocity.cross(Vector3d(0, 0, 2));
    spec.joints = {{.type = type, .first = 0, .second = 1, .anchor_W = {1, 2, 4}}};
    Simulation simulation(spec);
    simulation.step();
    const double start = support::total_energy(spec, simulation.states());
    for (int i = 0; i < 600; ++i) simulation.step();
    const double end = support::total_energy(spec, simulation.states());
    EXPECT_LE(end, start * (1 + 1e-9));
    EXPECT_GT(end, 0.9 * start);
  }
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
