#include "hydro/mesh/primitives.h"
#include "tests/engine/prelude.h"

/// Bodies with a resistance along their motion.

namespace {

constexpr double kMass = 500;    ///< Of the box [kg].
constexpr double kFactor = 200;  ///< Of the square of the speed [kg/m].

/// A box of 1 m that floats at half of its height without drag, and goes ahead.
SimulationSpec gliding(double speed, double factor = kFactor) {
  SimulationSpec spec = support::box_in_still_water({0, 0, 0});
  BodySpec& body = spec.bodies[0];
  body.coefficients.pressure_drag = {0, 0};
  body.coefficients.lift = 0;
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  body.added_mass = nullptr;
  body.initial.linear_velocity.x() = speed;
  body.locked = {false, true, true, true, true, true};
  body.resistance = std::make_shared<const hydro::Resistance>(
      hydro::Resistance{.curve = {{1}, {factor}}, .at_B = {0, 0, -0.25}, .volume = 0.5});
  spec.record_work = true;
  return spec;
}

TEST(ResistanceMotion, SlowsABodyAsTheSquareOfItsSpeed) {
  ASSERT_NEAR(gliding(3).bodies[0].mass, kMass, 1e-9);
  const Simulation after = support::after(gliding(3), support::steps_in(5, kStep));
  const double exact = 3 / (1 + kFactor / kMass * 3 * 5);
  EXPECT_NEAR(after.states()[0].linear_velocity.x(), exact, tolerance(1e-5));
}

TEST(ResistanceMotion, TakesTheEnergyThatItsWorkSays) {
  const Simulation after = support::after(gliding(3), support::steps_in(5, kStep));
  const double lost = kMass / 2 * (9 - after.states()[0].linear_velocity.squaredNorm());
  const engine::BodyForces forces = after.forces()[0];
  // The reported velocity has the correction (E9) by the present load.
  EXPECT_NEAR(forces.works.resistance, -lost, tolerance(1e-4) * lost);
  EXPECT_NEAR(forces.works.sum(), forces.works.resistance, tolerance(1e-9) * lost);
  const double speed = after.states()[0].linear_velocity.x();
  EXPECT_NEAR(forces.water.resistance.force.x(), -kFactor * speed * speed, tolerance(1e-9));
  EXPECT_NEAR(forces.water.resistance.moment.y(), 0.25 * kFactor * speed * speed, tolerance(1e-9));
}

TEST(ResistanceMotion, IsThatOfTheSpeedInTheWater) {
  SimulationSpec spec = gliding(4);
  spec.sea->current = {1, 0, 0};
  const Simulation after = support::after(spec, support::steps_in(5, kStep));
  const double exact = 1 + 3 / (1 + kFactor / kMass * 3 * 5);
  EXPECT_NEAR(after.states()[0].linear_velocity.x(), exact, tolerance(1e-5));
  EXPECT_NEAR(Simulation(gliding(4)).forces()[0].water.resistance.force.x(), -16 * kFactor,
              tolerance(1e-9));
  EXPECT_NEAR(Simulation(spec).forces()[0].water.resistance.force.x(), -9 * kFactor,
              tolerance(1e-9));
}

TEST(ResistanceMotion, IsThereWithoutAnyOtherLoadOfTheWater) {
  SimulationSpec spec = gliding(3);
  spec.bodies[0].coefficients.buoyancy = false;
  const Simulation after = support::after(spec, support::steps_in(5, kStep));
  EXPECT_NEAR(after.states()[0].linear_velocity.x(), 3 / (1 + kFactor / kMass * 3 * 5),
              tolerance(1e-5));
}

// Explicit steps would turn the motion about: h R'/m is 120.
TEST(ResistanceMotion, StopsABodyThatItIsStiffFor) {
  Simulation simulation(gliding(3, 1e6));
  double last = 3;
  for (int i = 0; i < 100; ++i) {
    simulation.step();
    const double speed = simulation.states()[0].linear_velocity.x();
    EXPECT_GE(speed, 0);
    EXPECT_LT(speed, last);
    last = speed;
  }
  EXPECT_LT(last, 0.02);
}

TEST(ResistanceMotion, EndsWhereABodyLeavesTheWater) {
  SimulationSpec spec = gliding(3);
  spec.bodies[0].initial.position.z() = 0.6;
  const Simulation after = support::after(spec, 100);
  EXPECT_EQ(after.states()[0].linear_velocity.x(), 3);
}

}  // namespace
