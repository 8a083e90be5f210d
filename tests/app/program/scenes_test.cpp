#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "app/assembly/build.h"
#include "app/scene/reader.h"
#include "engine/simulation.h"

/// Every scene that comes with the program.

namespace {

namespace fs = std::filesystem;

const fs::path kScenes = fs::path(PLIMSOLL_SOURCE_DIR) / "scenes";

/// Names of the scenes relative to the folder of scenes, sorted.
std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(kScenes))
    if (entry.path().extension() == ".yaml")
      names.push_back(fs::relative(entry.path(), kScenes).string());
  std::sort(names.begin(), names.end());
  return names;
}

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

class ShippedScene : public testing::TestWithParam<std::string> {};

TEST_P(ShippedScene, IsRight) {
  const scene::Scene scene = scene::read(kScenes / GetParam());
  EXPECT_FALSE(scene.title.empty());
  const assembly::BuiltScene built = assembly::build_without_added_mass(scene);
  EXPECT_THAT(built.notes, testing::IsEmpty());
}

/// A scene whose added masses are solved in a tenth of the time and less: no digit of them matters.
scene::Scene coarsely_solved(scene::Scene scene) {
  constexpr double kTolerance = 0.02;
  for (scene::Body& body : scene.bodies)
    body.hydro.added_mass.tolerance = std::max(body.hydro.added_mass.tolerance, kTolerance);
  return scene;
}

// The simulation refuses states beyond 1e9 by itself; in a second or two nothing goes far.
TEST_P(ShippedScene, RunsWithinBoundsSolvesItsConstraintsAndRepeatsItselfBitForBit) {
  const scene::Scene scene = coarsely_solved(scene::read(kScenes / GetParam()));
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

double kinetic_energy(const engine::SimulationSpec& spec,
                      const std::vector<hydro::BodyState>& states) {
  double sum = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Eigen::Vector3d spin_B = states[i].orientation.conjugate() * states[i].angular_velocity;
    sum += spec.bodies[i].mass * states[i].linear_velocity.squaredNorm() +
           spin_B.dot(spec.bodies[i].inertia_B * spin_B);
  }
  return sum / 2;
}

/// That a step leaves no more than so many times the energy of the motion.
void expect_nothing_thrown(const std::string& scene, double most) {
  const fs::path file = fs::path(PLIMSOLL_SOURCE_DIR) / "tests/data" / scene;
  const engine::SimulationSpec spec = assembly::build_without_added_mass(scene::read(file)).spec;
  engine::Simulation simulation(spec);
  const double start = kinetic_energy(spec, simulation.states());
  simulation.step();
  EXPECT_LT(kinetic_energy(spec, simulation.states()), most * start);
  long unsolved = 0;
  for (const engine::Counts& counts : simulation.counts()) unsolved += counts.unconverged;
  EXPECT_GT(unsolved, 0);
}

TEST(Contradictions, GiveNoEnergyWhereTheyAreNotSolved) {
  expect_nothing_thrown("contradictions.yaml", 1);
}

// A ball of 700 t lies deep in the others: what that holds is as much as the motion has.
TEST(Contradictions, ThrowNoBodyInManySubsteps) {
  expect_nothing_thrown("contradictions_in_many_substeps.yaml", 2);
}

std::string test_name(const testing::TestParamInfo<std::string>& scene) {
  std::string name = scene.param;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedScene, testing::ValuesIn(scene_names()), test_name);

}  // namespace
