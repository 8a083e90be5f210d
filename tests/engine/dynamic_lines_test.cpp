#include "engine/rig/dynamic_lines.h"

#include <numbers>

#include "tests/engine/prelude.h"
#include "tests/engine/rig_specs.h"

/// Lines with inertia on bodies, against catenaries and conservation laws.

namespace {

using engine::LineInertia;
using engine::LineReading;
using engine::LineSpec;
using engine::SimulationState;

constexpr double kWater = 1025;     // [kg/m^3]
constexpr double kDepth = 50;       // [m]
constexpr double kDiameter = 0.05;  // Of the chain [m].
constexpr double kChain = 60;       // [kg/m]

/// A buoy on one chain.
SimulationSpec buoy_on_chain(bool dynamic, double step, int segments = 40) {
  BodySpec buoy = support::sphere_body("buoy", 1.5, 400, {0, 0, 0.2});
  buoy.wet = true;
  SimulationSpec spec = support::dry_world({buoy}, step);
  spec.sea = hydro::Sea{};
  spec.sea->density = kWater;
  spec.sea->gravity = kGravity;
  spec.sea->depth = kDepth;
  LineSpec chain{
      .name = "chain",
      .kind = LineSpec::Kind::mooring,
      .first = {0, {0, 0, -1.5}},
      .second = {kWorld, {-70, 0, -kDepth}},
      .length = 95,
      .stiffness = 1e7,
      .weight = kGravity * (kChain - kWater * std::numbers::pi / 4 * kDiameter * kDiameter)};
  if (dynamic) {
    chain.inertia = LineInertia{.segments = segments,
                                .mass = kChain,
                                .drag_along = 0.05,
                                .added_mass = 1,
                                .bottom = -kDepth};
    chain.drag_diameter = kDiameter;
    chain.drag_coefficient = 1.2;
  }
  spec.lines = {chain};
  return spec;
}

LineReading chain_of(const Simulation& simulation) { return simulation.rig().lines.at(0); }

/// Height of a heaving buoy and what its line does, means over 30 s.
struct MeanOfHeave {
  double height = 0, tension = 0, pull = 0;
};
MeanOfHeave mean_of_heave(bool dynamic) {
  SimulationSpec spec = buoy_on_chain(dynamic, 0.02);
  spec.bodies[0].locked = {true, true, false, true, true, true};
  spec.bodies[0].initial.position.z() = -0.4;
  Simulation simulation = support::after(std::move(spec), support::steps_in(70, 0.02));
  MeanOfHeave mean;
  constexpr int kSteps = 1500;
  for (int i = 0; i < kSteps; ++i) {
    simulation.step();
    mean.height += simulation.states()[0].position.z() / kSteps;
    mean.tension += chain_of(simulation).tension / kSteps;
    mean.pull += chain_of(simulation).force_W.x() / kSteps;
  }
  return mean;
}

TEST(DynamicLine, LetsABuoySinkAsDeepAsUnderACatenary) {
  // A heave of 1 cm is left, which the catenary does not damp.
  const MeanOfHeave found = mean_of_heave(true), expected = mean_of_heave(false);
  EXPECT_NEAR(found.height, expected.height, tolerance(1e-3));
  EXPECT_NEAR(found.tension / expected.tension, 1, tolerance(2e-3));
  EXPECT_NEAR(found.pull / expected.pull, 1, tolerance(2e-3));
}

TEST(DynamicLine, OnALightBuoyIsStable) {
  for (const double mass : {5.0, 20.0, 40.0})
    for (const double step : {1.0 / 240, 1.0 / 60, 1.0 / 20}) {
      SimulationSpec spec = buoy_on_chain(true, step, 10);
      spec.bodies[0].mass /= mass;  // the chain's is 5,700 kg, the buoy's from 1,100 to 140
      spec.bodies[0].inertia_B /= mass;
      Simulation simulation(std::move(spec));
      for (int i = 0; i * step < 10; ++i) {
        simulation.step();
        ASSERT_LT(simulation.states()[0].linear_velocity.norm(), 12) << mass << ' ' << i * step;
      }
    }
}

/// Place of a buoy in equilibrium two seconds after it was first pulled aside, ever more.
Vector3d pulled_aside(double step) {
  SimulationSpec spec = buoy_on_chain(true, step, 10);
  spec.bodies[0].locked = {false, false, true, true, true, true};
  const Vector3d pull = chain_of(Simulation(spec)).force_W;
  spec.bodies[0].loads = {{.force = -pull},
                          {.force = {4e3, 2e3, 0}, .sine = engine::Sine{.frequency = 0.2}}};
  return support::after(std::move(spec), support::steps_in(2, step)).states()[0].position;
}

TEST(DynamicLine, MovesABodyInTheSquareOfTheStep) {
  const Vector3d exact = pulled_aside(0.00125);
  const double coarse = (pulled_aside(0.04) - exact).norm();
  const double fine = (pulled_aside(0.01) - exact).norm();
  EXPECT_LT(coarse, tolerance(5e-3));
  EXPECT_LT(fine, coarse / 8);  // it would be 16
}

TEST(DynamicLine, GoesOnFromASavedState) {
  SimulationSpec spec = buoy_on_chain(true, 0.02, 20);
  spec.bodies[0].initial.linear_velocity = {1, 0.5, 0};
  Simulation whole = support::after(spec, 60);
  const std::string bytes = whole.state().to_bytes();
  for (int i = 0; i < 60; ++i) whole.step();
  Simulation resumed(spec);
  resumed.restore(SimulationState::from_bytes(bytes));
  EXPECT_EQ(resumed.state().to_bytes(), bytes);
  for (int i = 0; i < 60; ++i) resumed.step();
  EXPECT_EQ(resumed.state().to_bytes(), whole.state().to_bytes());
  resumed.reset();
  EXPECT_EQ(resumed.states()[0].position, spec.bodies[0].initial.position);
}

TEST(DynamicLine, StateOfOtherLinesIsRefused) {
  Simulation simulation(buoy_on_chain(true, 0.02, 10));
  EXPECT_THROW(simulation.restore(Simulation(buoy_on_chain(true, 0.02, 12)).state()),
               std::invalid_argument);
  EXPECT_THROW(simulation.restore(Simulation(buoy_on_chain(false, 0.02)).state()),
               std::invalid_argument);
}

TEST(DynamicLine, FeelsTheCurrent) {
  SimulationSpec spec = buoy_on_chain(true, 0.02, 10);
  spec.sea->current = {0, 1.5, 0};
  spec.bodies[0].locked = {true, true, true, true, true, true};
  // More than half of its drag, as it is the upper end, and not all of it.
  const double drag = 0.5 * kWater * 1.2 * kDiameter * 1.5 * 1.5 * 95;
  const double found = chain_of(support::after(std::move(spec), 1500)).force_W.y();
  EXPECT_GT(found, drag / 2);
  EXPECT_LT(found, drag);
}

TEST(DynamicLine, ComesToRestWhereItsBodyIsPut) {
  SimulationSpec spec = buoy_on_chain(true, 0.02, 10);
  Simulation simulation(spec);
  BodyState there = spec.bodies[0].initial;
  there.position.x() += 3;
  simulation.set_motion(0, there);
  const double tension = chain_of(simulation).tension;
  spec.bodies[0].initial = there;
  EXPECT_EQ(chain_of(Simulation(spec)).tension, tension);
}

TEST(DynamicLine, BreaksAndPullsNoMore) {
  SimulationSpec spec = buoy_on_chain(true, 0.02, 10);
  spec.bodies[0].loads = {{.force = {4e5, 0, 0}}};
  spec.lines[0].breaks_at = 1e5;
  const Simulation simulation = support::after(spec, 500);
  Simulation resumed(spec);
  resumed.restore(simulation.state());
  for (const Simulation* broken : {&simulation, &std::as_const(resumed)}) {
    EXPECT_TRUE(chain_of(*broken).broken);
    EXPECT_EQ(chain_of(*broken).force_W, Vector3d::Zero());
    EXPECT_TRUE(chain_of(*broken).nodes_W.empty());
  }
  resumed.reset();
  EXPECT_EQ(chain_of(resumed).nodes_W.size(), 11u);
}

/// Two bodies in space on a rope with mass.
SimulationSpec two_in_space(double second_mass, double stiffness, double step) {
  BodySpec a = support::sphere_body("a", 1, 100, {0, 0, 0});
  BodySpec b = support::sphere_body("b", 1, 100, {10, 0, 0});
  b.mass *= second_mass;
  b.inertia_B *= second_mass;
  a.initial.linear_velocity = {-2, 0.5, 0};
  SimulationSpec spec = support::dry_world({a, b}, step);
  spec.gravity = 0;
  LineSpec rope =
      support::line(LineSpec::Kind::rope, {0, {1, 0, 0}}, {1, {-1, 0, 0.5}}, 8.5, stiffness);
  rope.inertia = LineInertia{.segments = 10, .mass = 1};
  spec.lines = {rope};
  return spec;
}

TEST(DynamicLine, BetweenBodiesGivesNoEnergyAndKeepsMomentum) {
  for (const double second : {1.0, 1e-3, 1e3})
    for (const double part : {0.3, 0.99})
      for (const double step : {1.0 / 240, 1.0 / 20}) {
        SimulationSpec spec = two_in_space(second, 1, step);
        const double longest = engine::longest_step(spec, spec.lines[0]);
        spec.lines[0].stiffness = std::pow(part * longest / step, 2);
        Simulation simulation(spec);
        const double mass = spec.bodies[0].mass, other = spec.bodies[1].mass;
        const Vector3d before = mass * spec.bodies[0].initial.linear_velocity;
        const double energy = before.squaredNorm() / mass / 2;
        for (int i = 0; i * step < 20; ++i) {
          simulation.step();
          const Vector3d v = simulation.states()[0].linear_velocity,
                         w = simulation.states()[1].linear_velocity;
          ASSERT_LT(mass / 2 * v.squaredNorm() + other / 2 * w.squaredNorm(), 1.001 * energy)
              << second << ' ' << part << ' ' << step << ' ' << i;
          // Up to 8.5 kg of rope, with up to twice the speed of some 400 kg, have a part of it.
          ASSERT_LT((mass * v + other * w - before).norm(), tolerance(0.13) * before.norm())
              << second << ' ' << part << ' ' << step << ' ' << i;
        }
      }
}

TEST(DynamicLine, TooStiffForTheStepBetweenBodiesIsRefused) {
  SimulationSpec spec = two_in_space(1, 1e9, 1.0 / 60);
  EXPECT_THROW(Simulation{spec}, std::invalid_argument);
  spec.bodies[1].locked = {true, true, true, true, true, true};
  EXPECT_NO_THROW(Simulation{spec});
}

TEST(DynamicLine, HangsBetweenTwoFloatsWhoseDraughtBearsIt) {
  BodySpec a = support::box_body("a", {2, 2, 1}, 400, {0, 0, 0.1}), b = a;
  b.name = "b";
  b.initial.position.x() = 12;
  for (BodySpec* body : {&a, &b}) {
    body->wet = true;
    body->locked = {true, true, false, true, true, true};
  }
  SimulationSpec spec = support::dry_world({a, b}, 1.0 / 60);
  spec.sea = hydro::Sea{};
  spec.sea->gravity = kGravity;
  LineSpec rope =
      support::line(LineSpec::Kind::rope, {0, {1, 0, 0}}, {1, {-1, 0, 0}}, 14, 1e5, 100);
  rope.weight = 120;
  rope.drag_diameter = 0.05;
  rope.drag_coefficient = 1.2;
  rope.inertia = LineInertia{.segments = 20, .mass = 14.2, .drag_along = 0.05, .added_mass = 1};
  spec.lines = {rope};
  Simulation simulation = support::after(std::move(spec), 2400);
  double height = 0;  // a mean over many heaves
  constexpr int kSteps = 2400;
  for (int i = 0; i < kSteps; ++i) {
    simulation.step();
    height += simulation.states()[0].position.z() / kSteps;
  }
  // Half of 14 m of 120 N/m is borne by 4 m² of waterplane.
  const double deeper = 0.5 * 14 * 120 / (1000 * kGravity * 4);
  const double afloat = 0.5 - 0.4;  // height of the centre of a box of 1 m and 400 kg/m³
  EXPECT_NEAR(height, afloat - deeper, tolerance(1e-3));
}

}  // namespace
