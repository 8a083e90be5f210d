#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/assembly/added_mass_store.h"
#include "app/assembly/build.h"
#include "app/scene/reader.h"
#include "engine/simulation.h"
#include "tests/support/shipped_scenes.h"
#include "tests/support/tolerance.h"

/// Every scene that comes with the program.

namespace {

using support::kScenes;

class ShippedScene : public testing::TestWithParam<std::string> {};

// Notes on meshes doubt them. Others tell which waves, added mass and damping a file has given.
bool doubts_mesh(const std::string& note) {
  return note.starts_with("bodies[") || note.starts_with("ground.");
}

TEST_P(ShippedScene, IsRight) {
  const scene::Scene scene = scene::read(kScenes / GetParam());
  EXPECT_FALSE(scene.title.empty());
  const assembly::BuiltScene built = assembly::build_without_added_mass(scene);
  EXPECT_THAT(built.notes, testing::Each(testing::Not(testing::Truly(doubts_mesh))));
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
  const std::filesystem::path file =
      std::filesystem::path(PLIMSOLL_SOURCE_DIR) / "tests/data" / scene;
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

// A ball of 700 t lies deep in the others: what that holds is as much as the motion has, and may be
// given in each time of a contact, five times in the step.
TEST(Contradictions, ThrowNoBodyInManySubsteps) {
  expect_nothing_thrown("contradictions_in_many_substeps.yaml", 10);
}

engine::SimulationSpec spec_of(const scene::Scene& scene) {
  assembly::AddedMassStore store(assembly::cache_folder());
  return assembly::build(scene, store).spec;
}

/// Places of all bodies after some times of so many steps, one after the other.
std::vector<Eigen::Vector3d> way_of_bodies(const engine::SimulationSpec& spec, int times,
                                           int steps) {
  engine::Simulation simulation(spec);
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < times; ++i) {
    for (int k = 0; k < steps; ++k) simulation.step();
    for (const hydro::BodyState& state : simulation.states()) places.push_back(state.position);
  }
  return places;
}

double largest_distance(const std::vector<Eigen::Vector3d>& a,
                        const std::vector<Eigen::Vector3d>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

/// Places of the teapot that falls into the water, every tenth of a second.
std::vector<Eigen::Vector3d> way_of_the_teapot(int steps_a_second) {
  scene::Scene scene = scene::read(kScenes / "teapot_drop.yaml");
  scene.step = 1.0 / steps_a_second;
  return way_of_bodies(spec_of(scene), 36, steps_a_second / 10);
}

// It has a hollow in few of the attitudes that it falls through. Steps of 1/100 and 1/300 s are off
// by at most 0.93 and 0.29 mm, where steps of 1/960 s stand for the truth.
TEST(Teapot, FallsTheSameWayInStepsOfAnyLength) {
  const std::vector<Eigen::Vector3d> fine = way_of_the_teapot(960);
  for (const int steps : {100, 300})
    EXPECT_LT(largest_distance(way_of_the_teapot(steps), fine), support::tolerance(1e-3)) << steps;
}

// An impact ends a substep at its onset, where round-off must not decide what touches: the crates
// would be off by micrometres at once, and by centimetres after six seconds.
TEST(CratesAfloat, MeetWhereTheyDoWhateverTheLastDigitsOfAPlace) {
  engine::SimulationSpec spec = spec_of(scene::read(kScenes / "crates_afloat.yaml"));
  double& x = spec.bodies[7].initial.position.x();
  const double before = x;
  const std::vector<Eigen::Vector3d> once = way_of_bodies(spec, 100, 1);
  for (const double moved : {1e-14, -1e-14, 1e-13, -1e-13, 3e-13, -3e-13}) {
    x = before + moved;
    EXPECT_LT(largest_distance(way_of_bodies(spec, 100, 1), once), support::tolerance(1e-11))
        << moved;  // some times what it was moved
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedScene, testing::ValuesIn(support::scene_names()),
                         support::scene_test_name);

}  // namespace
