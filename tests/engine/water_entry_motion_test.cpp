#include "hydro/added_mass/added_mass.h"
#include "hydro/added_mass/deep_added_mass.h"
#include "tests/engine/prelude.h"

namespace {

constexpr double kSpeed = 5;  // [m/s]

/// A ball of 1 m, twice as dense as the water, that falls into it without weight and without loads:
/// the water that it comes to move is all that slows it.
SimulationSpec entering_ball(double step) {
  BodySpec body = support::sphere_body("ball", 1, 2000, {0, 0, 1.01});
  body.wet = true;
  body.coefficients = {.buoyancy = false, .pressure_drag = {0, 0}, .lift = 0};
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  body.added_mass = std::make_shared<hydro::DeepAddedMass>(
      body.mesh_B, hydro::solve_added_mass(body.mesh_B, {.tolerance = 1e3}));
  body.initial.linear_velocity = {0, 0, -kSpeed};
  SimulationSpec spec = support::dry_world({body}, step);
  spec.sea.emplace();
  spec.gravity = 0;
  return spec;
}

/// A in heave of a body where it is [kg].
double heave(const SimulationSpec& spec, const hydro::BodyState& state) {
  return spec.bodies[0].added_mass->at(state, *spec.sea, 0)(2, 2);
}

// (E4): M V = (M + A) v at every depth, free, on rails and with locks, also in few steps.
TEST(WaterEntry, ABallThatEntersKeepsTheMomentumOfItselfAndTheWater) {
  for (const double step : {1.0 / 30, 1.0 / 240}) {
    const SimulationSpec free = entering_ball(step);
    SimulationSpec railed = free, locked = free;
    railed.joints = {{.type = JointSpec::Type::slider, .first = 0}};
    locked.bodies[0].locked = {true, true, false, true, true, true};
    for (const SimulationSpec& spec : {free, railed, locked}) {
      Simulation simulation(spec);
      const double mass = spec.bodies[0].mass;
      while (simulation.time() < 0.15) {
        simulation.step();
        const hydro::BodyState& state = simulation.states()[0];
        // A is that of a pose a little off (kUnmatchedAddedMass), in each of some updates.
        EXPECT_NEAR(-state.linear_velocity.z() * (mass + heave(spec, state)), mass * kSpeed,
                    tolerance(3e-3 * mass * kSpeed))
            << step << " at " << simulation.time();
      }
      EXPECT_GT(heave(spec, simulation.states()[0]), 0.05 * mass);
    }
  }
}

// Miloh's impulse: ½ρπR²V ∫ Cs dh up to 0.2 R, with Cs from 0 by the square root to 0.68 at 0.02,
// linear on to 1.19 at 0.1 and 1.24 at 0.2: 0.205 R. Of a heavy ball, whose speed stays.
TEST(WaterEntry, ABallThatEntersLosesTheMomentumOfTheory) {
  SimulationSpec spec = entering_ball(1e-3);
  BodySpec& body = spec.bodies[0];
  body.mass *= 1e3;
  body.inertia_B *= 1e3;
  Simulation simulation(spec);
  while (simulation.states()[0].position.z() > 0.8) simulation.step();
  const double lost = body.mass * (kSpeed + simulation.states()[0].linear_velocity.z());
  const double theory = 0.5 * 1000 * M_PI * kSpeed * 0.205;
  EXPECT_NEAR(lost, theory, tolerance(0.15 * theory));
}

}  // namespace
