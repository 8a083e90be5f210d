#include "app/assembly/sea_warnings.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "app/assembly/build.h"
#include "app/scene/reader.h"
#include "tests/app/scene_text.h"

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::vector<std::string> warnings_of(const std::string& text) {
  return assembly::build_without_added_mass(support::read_scene_text(text)).warnings;
}

/// The warnings of a sea without bodies, with a step that any wave in question is long for.
std::vector<std::string> of_water(const std::string& water) {
  return warnings_of("plimsoll: 1\nduration: 1\nstep: 1e-3\nwater: {" + water + "}\n");
}

std::vector<std::string> of_waves(const std::string& waves, const std::string& more = "") {
  return of_water(more + "surface: {waves: [" + waves + "]}");
}

std::vector<std::string> of_spectrum(double height, double period, const std::string& more = "") {
  return of_water(
      fmt::format("{}surface: {{spectrum: {{type: jonswap, significant_height: {}, "
                  "peak_period: {}}}}}",
                  more, height, period));
}

TEST(SeaWarnings, AWaveThatWouldBreakIsNamed) {
  // H/λ = 1/7 at an amplitude of 1 m and a length of 14 m.
  EXPECT_THAT(
      of_waves("{amplitude: 0.1, wavelength: 9}, {amplitude: 1.01, wavelength: 14}"),
      ElementsAre("water.surface.waves[1].amplitude: the height of the wave is 0.144 of its "
                  "length, and waves break from 0.143 on; expected at most 1 m"));
  EXPECT_THAT(of_waves("{amplitude: 0.99, wavelength: 14}"), IsEmpty());
}

TEST(SeaWarnings, AWaveBreaksEarlierOnShallowWater) {
  // tanh kh = 0.5 at kh = 0.5493: h = 8.743 m for a length of 100 m. The limit of a/h is lower.
  const std::string depth = "depth: 8.743, ";
  EXPECT_THAT(of_waves("{amplitude: 3.6, wavelength: 100}", depth),
              ElementsAre(HasSubstr("waves break from 0.0714 on; expected at most 3.57 m"),
                          HasSubstr("half the height of the wave is 0.412 of water.depth")));
  EXPECT_THAT(
      of_waves("{amplitude: 3.5, wavelength: 100}", depth),
      ElementsAre("water.surface.waves[0].amplitude: half the height of the wave is 0.4 of "
                  "water.depth, and linear theory ends above 0.2; expected at most 1.75 m"));
  EXPECT_THAT(of_waves("{amplitude: 1.7, wavelength: 100}", depth), IsEmpty());
}

TEST(SeaWarnings, ALongWaveOnShallowWaterIsNamedByTheKeyThatGivesIt) {
  // kh = 0.3 at a length of 2πh/0.3 = 20.9 m on 1 m.
  EXPECT_THAT(
      of_waves("{amplitude: 0.1, wavelength: 21}", "depth: 1, "),
      ElementsAre("water.surface.waves[0].wavelength: the wave's kh is 0.299 on water.depth "
                  "of 1 m, and linear theory ends below 0.3; expected a depth of at least 1 "
                  "m or a shorter wave"));
  EXPECT_THAT(of_waves("{amplitude: 0.1, period: 8}", "depth: 1, "),
              ElementsAre(StartsWith("water.surface.waves[0].period: the wave's kh is 0.25")));
  EXPECT_THAT(of_waves("{amplitude: 0.1, wavelength: 20.8}", "depth: 1, "), IsEmpty());
  EXPECT_THAT(of_waves("{amplitude: 0, wavelength: 50}", "depth: 1, "), IsEmpty());
}

TEST(SeaWarnings, ASeaThatWouldBreakIsNamed) {
  // A wave of 5 s is 39.02 m long on deep water; 1/14 of it is 2.787 m.
  EXPECT_THAT(of_spectrum(2.8, 5),
              ElementsAre("water.surface.spectrum.significant_height: the significant height is "
                          "0.0718 of the length of a wave of the peak period, and seas break from "
                          "0.0714 on; expected at most "
                          "2.79 m"));
  EXPECT_THAT(of_spectrum(2.78, 5), IsEmpty());
}

TEST(SeaWarnings, ASeaBeyondLinearTheoryIsNamed) {
  EXPECT_THAT(
      of_spectrum(1.3, 7, "depth: 3, "),
      ElementsAre("water.surface.spectrum.significant_height: half the height of the wave is "
                  "0.217 of water.depth, and linear theory ends above 0.2; expected at most "
                  "1.2 m"));
  EXPECT_THAT(of_spectrum(0.1, 20, "depth: 2, "),
              ElementsAre(StartsWith("water.surface.spectrum.peak_period: the wave's kh is 0.14")));
  EXPECT_THAT(of_spectrum(1.1, 7, "depth: 3, "), IsEmpty());
}

TEST(SeaWarnings, AFixedSurfaceThatIsTooSteepIsNamed) {
  const auto with_cells = [](double cell) {
    return of_water(
        fmt::format("surface: {{heightfield: {{file: {}/tests/data/heights/step.csv, cell: {}}}}}",
                    PLIMSOLL_SOURCE_DIR, cell));
  };
  EXPECT_THAT(with_cells(0.9),
              ElementsAre("water.surface.heightfield: neighbouring heights differ by 1.11 of the "
                          "cell, and no water is so steep; expected at most 1"));
  EXPECT_THAT(with_cells(1.1), IsEmpty());
}

TEST(SeaWarnings, AStepTooLongForTheShortestWaveIsNamed) {
  const auto with_step = [](double step, const std::string& waves) {
    return warnings_of(fmt::format(
        "plimsoll: 1\nduration: 1\nstep: {}\nwater: {{surface: {{waves: [{}]}}}}\n", step, waves));
  };
  const std::string swell = "{amplitude: 0.005, period: 0.8}";
  const std::string chop = "{amplitude: 0.002, period: 0.3}";
  EXPECT_THAT(with_step(0.031, swell + ", " + chop),
              ElementsAre("step: 0.031 s is 0.103 of the period of the shortest wave, 0.3 s; "
                          "expected at most 0.03 s"));
  EXPECT_THAT(with_step(0.029, swell + ", " + chop), IsEmpty());
  // A ripple with 4 % of the energy needs no step of its own.
  EXPECT_THAT(with_step(0.031, swell + ", {amplitude: 0.001, period: 0.3}"), IsEmpty());
}

TEST(SeaWarnings, GroundThatDeepWaterWavesWouldFeelIsNamed) {
  const auto over_ground = [](double z, const std::string& water) {
    return warnings_of(fmt::format(
        "plimsoll: 1\nduration: 1\nground: {{z: {}}}\nwater: {{level: 2, {}}}\n", z, water));
  };
  const std::string waves =
      "surface: {waves: [{amplitude: 0.1, wavelength: 9}, "
      "{amplitude: 0.4, wavelength: 20}]}";
  EXPECT_THAT(over_ground(-7.9, waves),
              ElementsAre("water.depth: missing, so the waves are those of deep water, but ground "
                          "lies 9.9 m below water.level, and waves of 20 m length feel it down to "
                          "10 m; expected water.depth: 9.9"));
  EXPECT_THAT(over_ground(-8.1, waves), IsEmpty());
  EXPECT_THAT(over_ground(-7.9, "depth: 9.9, " + waves), IsEmpty());
  EXPECT_THAT(over_ground(3, waves), IsEmpty());  // above the water
  EXPECT_THAT(over_ground(-7.9, "surface: {flat: {}}"), IsEmpty());
  EXPECT_THAT(over_ground(-15,
                          "surface: {spectrum: {type: jonswap, significant_height: 1, "
                          "peak_period: 5}}"),
              ElementsAre(HasSubstr(
                  "waves of 39 m length feel it down to 19.5 m; expected water.depth: 17")));
}

TEST(SeaWarnings, OfTheScenesThatComeWithTheProgramNoneWarns) {
  std::set<std::string> warned;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(PLIMSOLL_SOURCE_DIR "/scenes"))
    if (scene::is_scene_file(entry.path()) &&
        !assembly::build_without_added_mass(scene::read(entry.path())).warnings.empty())
      warned.insert(entry.path().stem().string());
  EXPECT_THAT(warned, IsEmpty());
}

/// The warnings of a dry scene with a box of 1 m at the origin and what a test adds.
std::vector<std::string> of_box_and(const std::string& more, const std::string& rest = "") {
  return warnings_of("plimsoll: 1\nduration: 1\nbodies:\n" +
                     std::string("  - {name: a, box: {size: [1, 1, 1]}, density: 500}\n") + more +
                     rest);
}

std::string box_at(const std::string& position, const std::string& more = "") {
  return "  - {name: b, box: {size: [1, 1, 1]}, density: 500, position: " + position + more + "}\n";
}

TEST(StartWarnings, NameBodiesThatOverlap) {
  EXPECT_THAT(of_box_and(box_at("[0.6, 0.5, -0.7]")),
              ElementsAre(StartsWith("bodies[1].position: 'b' overlaps 'a' at the start")));
  EXPECT_THAT(of_box_and("  - {name: b, icosphere: {radius: 0.2, subdivisions: 1}, density: 9}\n"),
              ElementsAre(HasSubstr("'b' overlaps 'a'")));  // wholly inside
  EXPECT_THAT(of_box_and(box_at("[0.6, 0, 0]", ", lock: all")),
              ElementsAre(StartsWith("bodies[0].position")));
  EXPECT_THAT(of_box_and("", "ground: {z: -0.4}\n"), ElementsAre(HasSubstr("overlaps the ground")));
}

TEST(StartWarnings, AreNoneForBodiesThatRestOnEachOtherOrMayOverlap) {
  EXPECT_THAT(of_box_and(box_at("[0, 0, 0.96]")), IsEmpty());
  EXPECT_THAT(of_box_and(box_at("[3, 0, 0]")), IsEmpty());
  // Boxes around them overlap, they do not.
  EXPECT_THAT(of_box_and(box_at("[1.1, 0.9, 0]", ", orientation: {euler_deg: [0, 0, 45]}")),
              IsEmpty());
  EXPECT_THAT(of_box_and(box_at("[0.6, 0, 0]", ", collision: none")), IsEmpty());
  EXPECT_THAT(of_box_and(box_at("[0.6, 0, 0]"),
                         "joints: [{name: j, type: ball, bodies: [a, b], anchor: [0.3, 0, 0]}]\n"),
              IsEmpty());
  EXPECT_THAT(of_box_and("", "ground: {z: -0.49}\n"), IsEmpty());
}

TEST(LineWarnings, ACatenaryThatSwingsAsSlowlyAsTheWavesIsNamed) {
  // 2 L √(m/T): L 127 m off the bottom, m 51 kg/m with 5 of water, T 94 kN.
  const auto of_chain = [](double period, const std::string& more) {
    return warnings_of(fmt::format(
        "plimsoll: 1\nduration: 1\nwater: {{density: 1025, surface: {{waves: [{{amplitude: 0.5, "
        "period: {}}}]}}}}\nbodies: [{{name: float, cylinder: {{radius: 5, height: 4}}, density: "
        "500}}]\nmoorings: [{{name: west, body: float, fairlead: [-5, 0, -1], anchor: [-150, 0, "
        "-50], length: 158, weight: 500, stiffness: 2e8, drag: {{diameter: 0.054}}{}}}]\n",
        period, more));
  };
  EXPECT_THAT(of_chain(8, ""),
              testing::Contains(HasSubstr("moorings[0]: the line swings in 6.2 s and the waves "
                                          "have 8 s, so that its inertia and drag count")));
  EXPECT_THAT(of_chain(15, ""), testing::Not(testing::Contains(HasSubstr("swings"))));
  EXPECT_THAT(of_chain(8, ", model: dynamic"),
              testing::Not(testing::Contains(HasSubstr("swings"))));
}

}  // namespace
