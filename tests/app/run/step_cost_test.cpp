#include "app/run/step_cost.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hydro/mesh/primitives.h"
#include "hydro/wave_spectrum.h"

namespace {

using testing::HasSubstr;
using testing::Not;

engine::SimulationSpec floating_box() {
  engine::SimulationSpec spec;
  spec.step = 0.01;
  spec.sea.emplace();
  engine::BodySpec& body = spec.bodies.emplace_back();
  body.name = "box";
  body.mesh_B = hydro::make_box({1, 1, 1});
  body.mass = 400;
  body.wet = true;
  return spec;
}

TEST(StepCost, LeavesTheSimulationWhereItWas) {
  engine::Simulation simulation(floating_box());
  const auto cost = app::measured_cost(simulation);
  ASSERT_TRUE(cost);
  EXPECT_GT(cost->seconds, 0);
  EXPECT_FALSE(cost->at_least);
  EXPECT_EQ(simulation.steps(), 0);
  EXPECT_EQ(simulation.counts()[0].substeps, 0);
  engine::Simulation other(floating_box());
  for (int i = 0; i < 50; ++i) {
    simulation.step();
    other.step();
  }
  EXPECT_EQ(simulation.states()[0].position, other.states()[0].position);
}

TEST(StepCost, NamesKeysOnlyWhereStepsAreSlowerThanRealTime) {
  engine::SimulationSpec spec = floating_box();
  EXPECT_EQ(app::cost_text({.seconds = 0.001, .loads = 0.9}, spec),
            "1 ms a step, 10 x real time, 90 % of it loads");
  EXPECT_EQ(app::cost_text({.seconds = 0.25, .at_least = true, .loads = 0.2}, spec),
            "more than 250 ms a step, less than 0.04 x real time; a longer step takes less");
  const app::StepCost slow{.seconds = 0.02, .loads = 0.9};
  EXPECT_THAT(app::cost_text(slow, spec), Not(HasSubstr("wave_tolerance")));
  spec.sea->surface =
      hydro::jonswap_sea({.significant_height = 1, .peak_period = 5, .components = 64}, *spec.sea);
  EXPECT_THAT(app::cost_text(slow, spec), HasSubstr("hydro.wave_tolerance"));
}

}  // namespace
