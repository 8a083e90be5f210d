#include "app/assembly/build_water.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/assembly/build.h"
#include "app/base/reporter.h"
#include "tests/app/scene_text.h"
#include "tests/support/tolerance.h"

namespace {

using support::tolerance;
using testing::HasSubstr;

std::string scene_of(const std::string& simulated, const std::string& bodies) {
  return "plimsoll: 1\nduration: 1\nstep: 0.02\nwater: {simulated: " + simulated + "}\nbodies:\n" +
         bodies;
}

const char kBarge[] = "  - {name: barge, box: {size: [10, 4, 2.4]}, density: 417}\n";
const char kBuoy[] =
    "  - {name: buoy, icosphere: {radius: 0.5, subdivisions: 2}, mass: 250, "
    "center_of_mass: [0, 0, -0.1], position: [0, 9, 0]}\n";

assembly::BuiltScene built(const std::string& text, app::Reporter& reporter = app::quiet()) {
  const scene::Scene scene = support::read_scene_text(text);
  assembly::AddedMassStore store(std::nullopt);
  return assembly::build(scene, store, reporter);
}

std::string fault_of(const std::string& text) {
  try {
    assembly::build_without_added_mass(support::read_scene_text(text));
  } catch (const scene::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(BuildWater, ChoosesAGridThatSuitsTheHulls) {
  const assembly::BuiltScene scene = built(scene_of("{}", kBarge));
  ASSERT_TRUE(scene.spec.water);
  const hydro::PeriodicSquare& square = scene.spec.water->square;
  EXPECT_NEAR(square.cell, 1, tolerance(1e-9));  // A quarter of the breadth.
  EXPECT_EQ(square.cells, 256);                  // 60 mean radii of 3.2 m.
  EXPECT_NEAR(square.deepest, 1, tolerance(2e-3));
  EXPECT_TRUE(scene.spec.bodies[0].sources);
  EXPECT_EQ(scene.spec.bodies[0].radiation->memory().size(), 0);
  EXPECT_EQ(scene.spec.bodies[0].added_mass, scene.spec.bodies[0].radiation);
}

TEST(BuildWater, TakesTheGridThatIsGiven) {
  const assembly::BuiltScene scene =
      built(scene_of("{size: [128, 128], spacing: 0.7, edge: 12}", kBarge));
  EXPECT_EQ(scene.spec.water->square.cells, 128);
  EXPECT_EQ(scene.spec.water->square.cell, 0.7);
  EXPECT_EQ(scene.spec.water->edge, 12);
}

TEST(BuildWater, GivesEqualHullsTheSameSources) {
  const assembly::BuiltScene scene =
      built(scene_of("{}", std::string(kBarge) +
                               "  - {name: other, box: {size: [10, 4, 2.4]}, density: 417, "
                               "position: [0, 9, 0]}\n" +
                               kBuoy));
  const std::vector<engine::BodySpec>& bodies = scene.spec.bodies;
  EXPECT_EQ(bodies[0].sources, bodies[1].sources);
  EXPECT_NE(bodies[0].sources, bodies[2].sources);
}

TEST(BuildWater, TellsHullsOfOnePoseApartByTheirMeshes) {
  const auto wall = [](const std::string& name, const std::string& size, int place) {
    return "  - {name: " + name + ", box: {size: " + size +
           "}, density: 500, lock: all, position: [" + std::to_string(place) + ", 0, -1]}\n";
  };
  const assembly::BuiltScene scene =
      built(scene_of("{}", wall("short", "[2, 10, 6], divisions: 2", 0) +
                               wall("long", "[2, 30, 6], divisions: 3", 20) +
                               wall("same", "[2, 10, 6], divisions: 2", 40)));
  const std::vector<engine::BodySpec>& bodies = scene.spec.bodies;
  EXPECT_NE(bodies[0].sources, bodies[1].sources);
  EXPECT_EQ(bodies[0].sources, bodies[2].sources);
}

TEST(BuildWater, LeavesOutWhatIsNarrowerThanACell) {
  const assembly::BuiltScene scene = built(scene_of("{spacing: 1.5}", std::string(kBarge) + kBuoy));
  EXPECT_TRUE(scene.spec.bodies[0].sources);
  EXPECT_FALSE(scene.spec.bodies[1].sources);
  EXPECT_THAT(scene.radiation[1].choice.reason, HasSubstr("less than a cell of the water, 1.5 m"));
}

TEST(BuildWater, MakesAHullOfWhatIsHeldInTheWater) {
  const assembly::BuiltScene scene =
      built(scene_of("{}", std::string(kBarge) +
                               "  - {name: wall, box: {size: [2, 30, 6]}, density: 500, lock: all, "
                               "position: [20, 0, -1]}\n"));
  EXPECT_TRUE(scene.spec.bodies[1].sources);
}

TEST(BuildWater, RefusesGridsThatCannotBe) {
  EXPECT_THAT(fault_of(scene_of("{size: [128, 256]}", kBarge)),
              HasSubstr("found [128, 256], expected two equal powers of two"));
  EXPECT_THAT(fault_of(scene_of("{size: [100, 100]}", kBarge)), HasSubstr("powers of two"));
  EXPECT_THAT(fault_of(scene_of("yes", kBarge)), HasSubstr("none, picture, or {}"));
  EXPECT_THAT(fault_of(scene_of("{spacing: -1}", kBarge)), HasSubstr("spacing"));
}

}  // namespace
