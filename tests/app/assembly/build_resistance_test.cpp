#include "app/assembly/build_resistance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/assembly/build.h"
#include "hydro/resistance/thin_ship.h"
#include "tests/app/build_fault.h"
#include "tests/app/scene_text.h"
#include "tests/support/tolerance.h"

namespace {

using assembly::BuiltScene;
using support::tolerance;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kMichell = "hydro: {added_mass: none, resistance: {wave: michell}}";

/// A scene with a slender ellipsoid that floats with its middle at the water, and more keys.
std::string a_spindle(const std::string& keys, const std::string& water = "{density: 1000}",
                      const std::string& more = "") {
  return "plimsoll: 1\nduration: 1\nwater: " + water +
         "\nbodies:\n  - {name: spindle, ellipsoid: {semi_axes: [5, 0.5, 0.5], slices: 24, "
         "stacks: 16}, density: 500, " +
         keys + "}\n" + more;
}

BuiltScene solved_now(const std::string& text) {
  assembly::AddedMassStore store{std::nullopt};
  return assembly::build(support::read_scene_text(text), store);
}

BuiltScene not_solved(const std::string& text) {
  return assembly::build_without_added_mass(support::read_scene_text(text));
}

TEST(BuildResistance, GivesAHullTheWavesOfItsPoseAtRest) {
  const std::string other = "position: [3, 1, 0.2], orientation: {euler_deg: [0, 4, 70]}, ";
  const BuiltScene built = solved_now(a_spindle(kMichell)),
                   tilted = solved_now(a_spindle(other + kMichell));
  const hydro::Resistance& resistance = *built.spec.bodies[0].resistance;
  const hydro::ThinShip& ship = *built.resistance[0].ship;
  EXPECT_NEAR(ship.length(), 10, tolerance(0.1));
  EXPECT_NEAR(resistance.curve.at(4), 1000 * ship.resistance(4, 9.80665),
              tolerance(0.01) * resistance.curve.at(4));
  // Half of an ellipsoid: its centre lies 3/8 of the semi-axis deep.
  EXPECT_NEAR(resistance.volume, 2.0 / 3 * M_PI * 5 * 0.25, tolerance(0.15));
  EXPECT_LT((resistance.at_B - Eigen::Vector3d(0, 0, -0.1875)).norm(), tolerance(0.01));
  EXPECT_NEAR(tilted.spec.bodies[0].resistance->curve.at(4), resistance.curve.at(4),
              tolerance(5e-3) * resistance.curve.at(4));
  EXPECT_THAT(built.warnings, IsEmpty());
}

TEST(BuildResistance, GivesTheWavesOfJoinedHullsToTheFirst) {
  const std::string twin =
      "  - {name: twin, ellipsoid: {semi_axes: [5, 0.5, 0.5], slices: 24, stacks: 16}, density: "
      "500, position: [0, 3, 0], " +
      kMichell + "}\njoints: [{name: beam, type: fixed, bodies: [spindle, twin]}]\n";
  const BuiltScene built = solved_now(a_spindle(kMichell, "{density: 1000}", twin));
  ASSERT_TRUE(built.resistance[0].ship);
  EXPECT_EQ(built.resistance[0].ship->parts().size(), 2u);
  EXPECT_FALSE(built.resistance[1].ship);
  EXPECT_FALSE(built.spec.bodies[1].resistance);
  // The force of both acts on the first in the middle between them.
  const hydro::Resistance& both = *built.spec.bodies[0].resistance;
  EXPECT_NEAR(both.volume, solved_now(a_spindle(kMichell)).spec.bodies[0].resistance->volume,
              tolerance(1e-3));
  EXPECT_LT((both.at_B - Eigen::Vector3d(0, 1.5, -0.1875)).norm(), tolerance(0.01));
}

TEST(BuildResistance, ReadsATable) {
  const auto file = std::filesystem::path(testing::TempDir()) / "build_resistance.csv";
  const std::string key = "hydro: {added_mass: none, resistance: {file: " + file.string() + "}}";
  std::ofstream(file) << "speed,force\n1,30\n2,120\n";
  const BuiltScene built = not_solved(a_spindle(key));
  ASSERT_TRUE(built.spec.bodies[0].resistance);
  EXPECT_NEAR(built.spec.bodies[0].resistance->curve.at(3), 270, tolerance(1e-9));
  // What sinks displaces all of its volume.
  const BuiltScene heavy =
      not_solved(a_spindle("orientation: {euler_deg: [0, 90, 0]}, " + key, "{density: 400}"));
  EXPECT_NEAR(heavy.spec.bodies[0].resistance->volume, 4.0 / 3 * M_PI * 5 * 0.25, tolerance(0.3));
  std::ofstream(file) << "speed,force\n1,30\n1,120\n";
  EXPECT_THAT(support::build_fault(a_spindle(key)),
              AllOf(HasSubstr("bodies[0].hydro.resistance.file: "),
                    HasSubstr("build_resistance.csv:3:1: found the speed 1 after 1")));
  std::filesystem::remove(file);
}

TEST(BuildResistance, RefusesWhatTheTheoryDoesNotKnow) {
  EXPECT_THAT(support::build_fault(a_spindle(kMichell, "{density: 400}")),
              AllOf(HasSubstr("bodies[0].hydro.resistance: found {wave: michell} for spindle: "),
                    HasSubstr("expected none")));
  const std::string box =
      "plimsoll: 1\nduration: 1\nwater: {density: 1000}\nbodies: [{name: box, box: {size: [3, 1, "
      "1]}, density: 200, " +
      kMichell + "}]\n";
  EXPECT_THAT(support::build_fault(box),
              HasSubstr("3 m long and 1 m wide, and thin-ship theory asks for"));
  EXPECT_THAT(
      support::build_fault("plimsoll: 1\nduration: 1\nbodies: [{name: box, box: {size: [3, 1, 1]}, "
                           "density: 200, " +
                           kMichell + "}]\n"),
      HasSubstr("the scene has no water"));
}

TEST(BuildResistance, LeavesTheWavesOfAHullToSimulatedWater) {
  const std::string simulated = "{density: 1000, simulated: {}}";
  const std::string keys = "hydro: {resistance: {wave: michell}}";
  EXPECT_THAT(support::build_fault(a_spindle(keys, simulated)),
              HasSubstr("the simulated water has the resistance of its waves"));
  const std::string none = "hydro: {radiation: none, resistance: {wave: michell}}";
  EXPECT_TRUE(not_solved(a_spindle(none, simulated)).resistance[0].ship);
}

TEST(BuildResistance, WarnsOfBluntEndsAndShallowWater) {
  EXPECT_THAT(not_solved(a_spindle(kMichell, "{density: 1000, depth: 4}")).warnings,
              ElementsAre(HasSubstr("the water is 4 m deep at a length of")));
  const std::string box =
      "plimsoll: 1\nduration: 1\nwater: {density: 1000}\nbodies: [{name: box, box: {size: [8, 1, "
      "0.5]}, density: 200, " +
      kMichell + "}]\n";
  EXPECT_THAT(not_solved(box).warnings, ElementsAre(HasSubstr("100 % of the section of box lie")));
}

TEST(BuildResistance, IsSolvedOnceForEqualHullsAndKept) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "kept_resistance";
  std::filesystem::remove_all(folder);
  const scene::Scene scene = support::read_scene_text(a_spindle(
      kMichell, "{density: 1000}",
      "  - {name: twin, ellipsoid: {semi_axes: [5, 0.5, 0.5], slices: 24, stacks: 16}, density: "
      "500, position: [0, 9, 0], " +
          kMichell + "}\n"));
  assembly::AddedMassStore store{folder};
  const BuiltScene first = assembly::build(scene, store), later = assembly::build(scene, store);
  EXPECT_FALSE(first.resistance[0].from_store);
  EXPECT_EQ(first.resistance[0].seconds, first.resistance[1].seconds);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(later.spec.bodies[i].resistance->curve.forces(),
              first.spec.bodies[0].resistance->curve.forces());
  // What takes less than a tenth of a second has no file.
  EXPECT_EQ(later.resistance[0].from_store, first.resistance[0].seconds > 0.1);
  std::filesystem::remove_all(folder);
}

}  // namespace
