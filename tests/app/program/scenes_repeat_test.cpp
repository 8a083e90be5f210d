#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/assembly/build.h"
#include "app/scene/reader.h"
#include "engine/simulation.h"
#include "tests/support/shipped_scenes.h"

/// Every scene that comes with the program, stepped at one and at two threads.

namespace {

using support::kScenes;

/// States of all bodies after each of the first steps, whose constraints must all be solved.
std::vector<std::vector<hydro::BodyState>> first_steps(const engine::SimulationSpec& spec) {
  constexpr int kSteps = 100;
  engine::Simulation simulation(spec);
  std::vector<std::vector<hydro::BodyState>> states;
  for (int i = 0; i < kSteps; ++i) {
    simulation.step();
    states.push_back(simulation.states());
  }
  for (const engine::Counts& counts : simulation.counts()) EXPECT_EQ(counts.unconverged, 0);
  return states;
}

class SteppedScene : public testing::TestWithParam<std::string> {};

// The simulation refuses states beyond 1e9 by itself; in a second or two nothing goes far.
TEST_P(SteppedScene, RunsWithinBoundsSolvesItsConstraintsAndRepeatsItselfBitForBit) {
  const scene::Scene scene = scene::read(kScenes / GetParam());
  assembly::AddedMassStore store(assembly::cache_folder());
  assembly::BuiltScene built = assembly::build(scene, store);
  engine::SimulationSpec& spec = built.spec;
  const auto once = first_steps(spec);
  for (const auto& states : once) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      ASSERT_LT((states[i].position - spec.bodies[i].initial.position).norm(), 100);
      ASSERT_LT(states[i].linear_velocity.norm(), 100);
      ASSERT_LT(states[i].angular_velocity.norm(), 100);
    }
  }
  spec.threads = 2;
  EXPECT_EQ(first_steps(spec), once);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SteppedScene, testing::ValuesIn(support::scene_names()),
                         support::scene_test_name);

}  // namespace
