#include "engine/state_data.h"
#include "hydro/airy_waves.h"
#include "hydro/radiation/diffraction_load.h"
#include "hydro/water/simulated_water.h"
#include "tests/engine/radiating_ball.h"
#include "tests/support/tolerance.h"

/// How hulls move in simulated water.

namespace {

using support::dry_world;
using support::kRho;
using support::tolerance;

constexpr hydro::PeriodicSquare kSquare{
    .cells = 128, .cell = 0.5, .deepest = 1, .layers = 5, .gravity = kGravity};

/// The ball of radiating_ball.h with sources in the square, as heavy as a part of the water that it
/// displaces; a load holds it half under water.
BodySpec felt_ball(const hydro::Sea& sea, double part = 1) {
  BodySpec ball = support::radiating_ball();
  static const auto sources = std::make_shared<const hydro::HullSources>(
      hydro::make_hull_sources(ball.mesh_B, {}, kSquare));
  ball.sources = sources;
  ball.radiation = hydro::floating_hull(*sources, ball.mesh_B, sea);
  ball.added_mass = ball.radiation;
  ball.loads.push_back({.force = {0, 0, (part - 1) * ball.mass * kGravity}});
  ball.inertia_B *= part;
  ball.mass *= part;
  return ball;
}

SimulationSpec in_water(std::vector<BodySpec> bodies, double step,
                        const hydro::PeriodicSquare& square = kSquare) {
  SimulationSpec spec = dry_world(std::move(bodies), step);
  spec.sea = hydro::Sea{.density = kRho, .gravity = kGravity};
  spec.water = engine::WaterGrid{.square = square, .edge = square.side() / 3};
  return spec;
}

/// A body that is let go from rest above its equilibrium; Cummins' equation has these turns.
TEST(WaterCoupling, DampsAHeavingSphereAsItsMemoryDoes) {
  const double unit = std::sqrt(1 / kGravity);  // [s]
  for (const double step : {0.01, 1.0 / 15}) {
    BodySpec ball = felt_ball({});
    ball.initial.position.z() = 0.05;
    Simulation simulation(in_water({ball}, step));
    for (const auto& [time, height] :
         {std::pair(3.10, -0.866), {6.18, 0.630}, {9.24, -0.459}, {12.28, 0.341}}) {
      while (simulation.time() + step / 2 < time * unit) simulation.step();
      EXPECT_NEAR(simulation.states()[0].position.z() / 0.05, height, tolerance(0.012))
          << step << ' ' << time;
    }
  }
}

/// The water's spring is taken implicitly, and its load is not late: no body is too light.
TEST(WaterCoupling, IsStableForBodiesOfAnyMass) {
  for (const double part : {0.01, 0.1})
    for (const double step : {1.0 / 60, 1.0 / 15}) {
      BodySpec ball = felt_ball({}, part);
      ball.initial.position = {0, 0, 0.05};
      ball.initial.linear_velocity.x() = 0.1;
      Simulation simulation(in_water({ball}, step));
      double late = 0;
      for (int i = 0; simulation.time() < 20; ++i) {
        simulation.step();
        const double z = simulation.states()[0].position.z();
        ASSERT_LT(std::abs(z), 0.051) << part << ' ' << step << ' ' << i;
        if (simulation.time() > 15) late = std::max(late, std::abs(z));
      }
      EXPECT_LT(late, 0.01) << part << ' ' << step;
    }
}

/// What the body loses is in the water, before its edges absorb it. Near a hull the water has a
/// fictitious part inside it. The error falls with the step of the water: 2 % with the longest, of
/// 0.12 s, and 1 % with half of that.
TEST(WaterCoupling, HasTheEnergyThatBodiesLose) {
  const hydro::PeriodicSquare square{
      .cells = 256, .cell = 0.5, .deepest = 1, .layers = 5, .gravity = kGravity};
  BodySpec ball = felt_ball({});
  ball.initial.position.z() = 0.05;
  SimulationSpec spec = in_water({ball}, 0.02, square);
  spec.water->edge = 12;
  Simulation simulation(spec);
  const engine::Body body = engine::make_bodies(simulation.spec())[0];
  const auto energy_of_body = [&] {
    return support::energy(body, simulation.state().data().bodies[0].motion);
  };
  const double before = energy_of_body();
  while (simulation.time() < 10) simulation.step();
  EXPECT_NEAR(kRho * simulation.water()->waves().energy() / (before - energy_of_body()), 1,
              tolerance(0.03));
}

/// The load of the water has columns of its own, and the works close the energy of the body to
/// second order in the step, though the load jumps between the steps of the water.
TEST(WaterCoupling, TellsTheLoadAndTheWorkOfTheWaterAsOne) {
  hydro::Sea sea{.density = kRho, .gravity = kGravity};
  sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.02, 12, 0.3, 0, kGravity)}};
  const auto off = [&](double step) {
    SimulationSpec spec = in_water({felt_ball(sea)}, step);
    spec.sea = sea;
    spec.record_work = true;
    spec.bodies[0].initial.position.z() = 0.05;
    Simulation simulation(spec);
    const double before = simulation.forces()[0].kinetic_energy;
    while (simulation.time() < 3 - step / 2) simulation.step();
    const engine::BodyForces forces = simulation.forces()[0];
    EXPECT_TRUE(forces.radiation.force.isZero(0) && forces.water.diffraction.force.isZero(0));
    EXPECT_EQ(std::abs(forces.works.radiation) + std::abs(forces.works.diffraction), 0);
    EXPECT_GT(forces.simulated_water.force.norm(), 1);
    EXPECT_LT(forces.works.water, 0);
    return std::abs(forces.works.sum() - forces.kinetic_energy + before) /
           std::abs(forces.works.water);
  };
  const double coarse = off(0.02), fine = off(0.01);
  EXPECT_LT(coarse, 3e-5);
  EXPECT_LT(fine, 0.4 * coarse);
}

TEST(WaterCoupling, BringsTheWavesOfOneBodyToAnother) {
  std::vector<BodySpec> balls(2, felt_ball({}));
  balls[0].initial.position.z() = 0.05;
  balls[1].name = "neighbour";
  balls[1].initial.position.x() = 3;
  Simulation simulation(in_water(balls, 0.02));
  double largest = 0;
  while (simulation.time() < 6) {
    simulation.step();
    largest = std::max(largest, std::abs(simulation.states()[1].position.z()));
  }
  // Its heave by the other's is a third of its own in the frequency domain, at kR near 1.
  EXPECT_GT(largest, 0.1 * 0.05);
  EXPECT_LT(largest, 0.6 * 0.05);
}

TEST(WaterCoupling, GoesOnFromItsStateToTheSameBits) {
  std::vector<BodySpec> balls(2, felt_ball({}));
  balls[0].initial.position.z() = 0.1;
  balls[1].name = "other";
  balls[1].initial.position.x() = 4;
  const SimulationSpec spec = in_water(balls, 0.01);
  Simulation whole(spec), second(spec);
  for (int i = 0; i < 33; ++i) whole.step();  // In the middle of a step of the water.
  second.restore(engine::SimulationState::from_bytes(whole.state().to_bytes()));
  for (int i = 0; i < 40; ++i) {
    whole.step();
    second.step();
  }
  EXPECT_TRUE(whole.state().to_bytes() == second.state().to_bytes());
  whole.reset();
  EXPECT_TRUE(whole.state().to_bytes() == Simulation(spec).state().to_bytes());
}

TEST(WaterCoupling, RefusesTheStateOfOtherWater) {
  const BodySpec ball = felt_ball({});
  SimulationSpec dry = in_water({ball}, 0.01);
  dry.bodies[0].sources = nullptr;
  dry.water.reset();
  Simulation simulation(in_water({ball}, 0.01)), other(dry);
  EXPECT_THROW(simulation.restore(other.state()), std::invalid_argument);
  EXPECT_THROW(other.restore(simulation.state()), std::invalid_argument);
}

}  // namespace
