#include "app/assembly/envelope.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/assembly/added_mass_store.h"
#include "app/assembly/build.h"
#include "tests/app/scene_text.h"

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The warnings of a scene with water and bodies, as `check` has them.
std::vector<std::string> of_bodies(const std::string& bodies,
                                   const std::string& more = "water: {}\n") {
  return assembly::build_without_added_mass(
             support::read_scene_text("plimsoll: 1\nduration: 1\n" + more + "bodies:\n" + bodies))
      .warnings;
}

std::string cube(double size, const std::string& more = "density: 900", const char* name = "a") {
  return fmt::format("  - {{name: {0}, box: {{size: [{1}, {1}, {1}]}}, {2}}}\n", name, size, more);
}

std::string line(const std::string& entries) {
  return "outside the operating envelope, where motions may gain energy: " + entries;
}

TEST(Envelope, SizesAreFromFiveMillimetresToFiveHundredMetres) {
  EXPECT_THAT(of_bodies(cube(0.00501)), IsEmpty());
  EXPECT_THAT(of_bodies(cube(499)), IsEmpty());
  EXPECT_THAT(of_bodies(cube(0.0049)),
              ElementsAre(line("body 'a': size 0.0049 m, expected at least 0.005 m")));
  EXPECT_THAT(of_bodies(cube(510)),
              ElementsAre(line("body 'a': size 510 m, expected at most 500 m")));
}

TEST(Envelope, TheSizeOfABodyIsItsLongestEdge) {
  EXPECT_THAT(of_bodies("  - {name: a, box: {size: [0.01, 0.001, 0.001]}, density: 900}\n"),
              IsEmpty());
}

TEST(Envelope, MassesAreThoseOfAHundredthToTwentyTimesTheWater) {
  EXPECT_THAT(of_bodies(cube(1, "density: 10.1")), IsEmpty());
  EXPECT_THAT(of_bodies(cube(1, "density: 19900")), IsEmpty());
  EXPECT_THAT(
      of_bodies(cube(1, "density: 9.9")),
      ElementsAre(line("body 'a': mass 0.0099 times that of its displaced water, expected at "
                       "least 0.01 times that of its displaced water")));
  EXPECT_THAT(
      of_bodies(cube(1, "density: 20100")),
      ElementsAre(line("body 'a': mass 20.1 times that of its displaced water, expected at most 20 "
                       "times that of its displaced water")));
  EXPECT_THAT(of_bodies(cube(1, "density: 20100"), ""), IsEmpty());  // without water
}

TEST(Envelope, SpeedsAndSpinsAreAtMostFifty) {
  EXPECT_THAT(
      of_bodies(cube(1, "density: 900, hydro: {radiation: none}, linear_velocity: [30, 0, -39.9]")),
      IsEmpty());
  EXPECT_THAT(
      of_bodies(cube(1, "density: 900, hydro: {radiation: none}, angular_velocity: [0, 49.9, 0]")),
      IsEmpty());
  EXPECT_THAT(
      of_bodies(cube(1, "density: 900, hydro: {radiation: none}, linear_velocity: [30, 0, -40.1]")),
      ElementsAre(line("body 'a': speed 50.08 m/s, expected at most 50 m/s")));
  EXPECT_THAT(
      of_bodies(cube(1, "density: 900, hydro: {radiation: none}, angular_velocity: [0, 50.1, 0]")),
      ElementsAre(line("body 'a': spin 50.1 rad/s, expected at most 50 rad/s")));
}

TEST(Envelope, StepsAreFromAThousandthToATwentiethOfASecond) {
  for (const char* step : {"0.001", "0.05"})
    EXPECT_THAT(of_bodies(cube(1), fmt::format("step: {}\n", step)), IsEmpty()) << step;
  EXPECT_THAT(of_bodies(cube(1), "step: 0.051\n"),
              ElementsAre(line("step 0.051 s, expected at most 0.05 s")));
  EXPECT_THAT(of_bodies(cube(1), "step: 0.00099\n"),
              ElementsAre(line("step 0.00099 s, expected at least 0.001 s")));
}

/// The warnings of a cube of 500 kg with a given added mass along z, as `run` has them.
std::vector<std::string> with_added_mass(double along_z) {
  assembly::AddedMassStore store(testing::TempDir());
  const scene::Scene scene = support::read_scene_text(fmt::format(
      "plimsoll: 1\nduration: 1\nwater: {{}}\nbodies:\n"
      "  - name: a\n    box: {{size: [1, 1, 1]}}\n    density: 500\n    position: [0, 0, 3]\n"
      "    hydro: {{added_mass: {{matrix: [[1,0,0,0,0,0],[0,1,0,0,0,0],[0,0,{},0,0,0],"
      "[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]]}}}}\n",
      along_z));
  return assembly::build(scene, store).warnings;
}

TEST(Envelope, AddedMassIsAtMostAHundredTimesTheMass) {
  EXPECT_THAT(with_added_mass(49900), IsEmpty());
  EXPECT_THAT(with_added_mass(50100), ElementsAre(line("body 'a': added mass 100.2 times its mass, "
                                                       "expected at most 100 times its mass")));
}

TEST(Envelope, ABodyWithoutFreedomIsNotJudged) {
  EXPECT_THAT(of_bodies("  []\n", "step: 0.1\n"), IsEmpty());
  EXPECT_THAT(of_bodies(cube(900, "density: 5, lock: all")), IsEmpty());
}

TEST(Envelope, WhatIsTooMuchForALineIsCounted) {
  std::string bodies;
  for (const char* name : {"a", "b", "c", "d", "e", "f"})
    bodies += cube(bodies.empty() ? 0.001 : 1,
                   fmt::format("density: 900, linear_velocity: [60, 0, 0], position: [{}, 0, 0]",
                               bodies.size()),
                   name);
  const std::vector<std::string> warnings = of_bodies(bodies, "");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], HasSubstr("body 'a': size"));
  EXPECT_THAT(warnings[0], testing::EndsWith("; and 3 more"));
}

engine::SimulationSpec in_wave(double amplitude) {
  return assembly::build_without_added_mass(
             support::read_scene_text(fmt::format(
                 "plimsoll: 1\nduration: 1\nwater: {{surface: {{waves: [{{amplitude: {}, "
                 "wavelength: 14}}]}}}}\n",
                 amplitude)))
      .spec;
}

TEST(Envelope, EndsWhereWavesBreak) {
  EXPECT_TRUE(assembly::inside_envelope(in_wave(0.99)));
  EXPECT_FALSE(assembly::inside_envelope(in_wave(1.01)));
}

TEST(Envelope, EndsWhereAHeightFieldIsSteeperThanItsCells) {
  engine::SimulationSpec spec = in_wave(0);
  Eigen::MatrixXd heights = Eigen::MatrixXd::Zero(2, 3);
  heights(1, 1) = 1.99;
  spec.sea->surface = hydro::make_height_field(heights, 2, {0, 0});
  EXPECT_TRUE(assembly::inside_envelope(spec));
  heights(1, 1) = 2.01;
  spec.sea->surface = hydro::make_height_field(heights, 2, {0, 0});
  EXPECT_FALSE(assembly::inside_envelope(spec));
}

}  // namespace
