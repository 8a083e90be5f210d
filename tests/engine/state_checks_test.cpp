#include <gmock/gmock.h>

#include <limits>

#include "tests/engine/prelude.h"

namespace {

using engine::SimulationError;
using testing::HasSubstr;

constexpr double kHuge = std::numeric_limits<double>::max();

/// Two bodies, the second of which meets its load at 0.5 s.
SimulationSpec with_load(const engine::AppliedLoad& load) {
  BodySpec calm = support::box_body("calm", {1, 1, 1}, 100, {0, 0, 0});
  BodySpec doomed = support::box_body("doomed", {1, 2, 3}, 100, {5, 0, 0});
  doomed.loads = {{.force = {1, 0, 0}}, load};
  doomed.loads[1].start = 0.5;
  return support::dry_world({calm, doomed}, kStep);
}

/// Steps until it fails; the error that ended it.
SimulationError failure(Simulation& simulation) {
  for (int i = 0; i < 1000; ++i) {
    const std::vector<hydro::BodyState> before = simulation.states();
    const long steps = simulation.steps();
    try {
      simulation.step();
    } catch (const SimulationError& error) {
      EXPECT_EQ(simulation.steps(), steps);
      for (std::size_t body = 0; body < before.size(); ++body) {
        EXPECT_EQ(simulation.states()[body].position, before[body].position);
        EXPECT_EQ(simulation.states()[body].linear_velocity, before[body].linear_velocity);
      }
      return error;
    }
  }
  throw std::logic_error("the simulation did not fail");
}

TEST(SimulationErrors, NameTheLoadThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Simulation simulation(with_load({.torque = {0, nan, 0}}));
  const SimulationError error = failure(simulation);
  EXPECT_EQ(error.body(), "doomed");
  EXPECT_EQ(simulation.steps(), 50);
  EXPECT_DOUBLE_EQ(error.time(), 0.5);
  EXPECT_THAT(error.what(), HasSubstr("moment y of applied load 2 is nan"));
}

TEST(SimulationErrors, NameTheBodyThatLeavesAllBoundsAndItsLargestLoad) {
  Simulation simulation(with_load({.force = {0, 0, 1e15}}));
  const SimulationError error = failure(simulation);
  EXPECT_EQ(error.body(), "doomed");
  EXPECT_DOUBLE_EQ(error.time(), 0.5);
  EXPECT_THAT(error.what(), HasSubstr("linear velocity's z is"));
  EXPECT_THAT(error.what(), HasSubstr("applied load 2, force z = 1e+15 N"));
}

TEST(SimulationErrors, ComeBeforeTheEngineMeetsAnOverflow) {
  const std::vector<engine::AppliedLoad> loads = {{.torque = {kHuge, 0, 0}},
                                                  {.torque = {1e200, 1e200, 0}},
                                                  {.force = {kHuge, kHuge, 0}},
                                                  {.force = {0, 0, 1e10}, .at_B = {1e300, 0, 0}}};
  for (const engine::AppliedLoad& load : loads) {
    Simulation simulation(with_load(load));
    const SimulationError error = failure(simulation);
    EXPECT_EQ(error.body(), "doomed");
    EXPECT_DOUBLE_EQ(error.time(), 0.5);
  }
}

// On a joint 4 cm from its centre the body's flight becomes a spin of 1e10 rad/s.
TEST(SimulationErrors, NameTheBodyThatAConstraintThrowsOutOfBounds) {
  BodySpec calm = support::box_body("calm", {1, 1, 1}, 100, {0, 0, 5});
  BodySpec whirl = support::box_body("whirl", {0.1, 0.1, 0.1}, 100, {0.04, 0, 0});
  whirl.initial.linear_velocity = {0, 9e8, 0};
  SimulationSpec spec = support::dry_world({calm, whirl}, 1e-9);
  spec.joints = {{.name = "lever", .first = 1}};
  Simulation simulation(spec);
  EXPECT_EQ(failure(simulation).body(), "whirl");
  EXPECT_THROW(simulation.step(), SimulationError);
}

TEST(SimulationErrors, AreFinal) {
  Simulation simulation(with_load({.force = {0, 0, 1e15}}));
  failure(simulation);
  EXPECT_THROW(simulation.step(), SimulationError);
  EXPECT_EQ(simulation.steps(), 50);
}

TEST(SimulationErrors, OfOneSimulationLeaveOthersAlone) {
  Simulation healthy(support::dry_world({support::box_body("b", {1, 1, 1}, 1, {0, 0, 0})}, kStep));
  Simulation doomed(with_load({.torque = {kHuge, 0, 0}}));
  failure(doomed);
  healthy.step();
  EXPECT_EQ(healthy.steps(), 1);
}

TEST(SimulationErrors, ComeFromAStepThatIsNotPositive) {
  EXPECT_THROW(Simulation(support::dry_world({}, 0)), std::invalid_argument);
}

}  // namespace
