#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/program/program.h"
#include "tests/app/scene_text.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr double kGravity = 9.80665;

/// A box of 8 m × 2 m × 1 m that floats half submerged, and other keys of it.
std::string barge(const std::string& keys = "", const std::string& water = "") {
  return "plimsoll: 1\n"
         "duration: 1\n"
         "water: {density: 1000" +
         water +
         "}\n"
         "bodies:\n"
         "  - {name: barge, box: {size: [8, 2, 1]}, density: 500" +
         keys + "}\n";
}

/// What the command prints, or the fault it throws.
std::string rao_of(std::vector<std::string> words) {
  words.insert(words.begin(), "rao");
  return support::output_of(std::move(words));
}

/// Responses of the barge.
json responses(const std::string& scene, const std::string& headings, const std::string& periods,
               std::vector<std::string> more = {}) {
  std::vector<std::string> words = {
      support::write_scene(scene), "--headings", headings, "--periods", periods, "--json"};
  words.insert(words.end(), more.begin(), more.end());
  return json::parse(rao_of(words))["bodies"]["barge"]["responses"];
}

double number(const json& row, const char* key) { return row[key].get<double>(); }

TEST(RaoCommand, InLongWavesABodyFollowsTheSurface) {
  const json rows = responses(barge(), "0,90,180", "30");
  ASSERT_EQ(rows.size(), 3u);
  const double k = std::pow(2 * M_PI / 30, 2) / kGravity, slope = k * 180 / M_PI;
  for (const json& row : rows) {
    EXPECT_NEAR(number(row, "wavelength"), 2 * M_PI / k, 1e-9);
    EXPECT_NEAR(number(row, "heave"), 1, 5e-3);
    EXPECT_NEAR(number(row, "heave_phase_deg"), 0, 1);
  }
  // Pitch is positive bow down: waves from ahead raise the bow a quarter of a period before the
  // crest, and those from abeam turn the body as their slope.
  EXPECT_NEAR(number(rows[2], "pitch_deg"), slope, 0.005 * slope);
  EXPECT_NEAR(number(rows[2], "pitch_phase_deg"), -90, 1);
  EXPECT_NEAR(number(rows[0], "pitch_phase_deg"), 90, 1);
  EXPECT_NEAR(number(rows[1], "roll_deg"), slope, 0.005 * slope);
  EXPECT_LT(number(rows[2], "roll_deg"), 1e-6);
  // Water moves along its waves under a crest.
  EXPECT_NEAR(number(rows[2], "surge"), 1, 0.005);
  EXPECT_NEAR(number(rows[2], "surge_phase_deg"), 90, 1);
  EXPECT_NEAR(number(rows[0], "surge_phase_deg"), -90, 1);
}

TEST(RaoCommand, SeesTheDepthOfVariablesAndIncludes) {
  const json written = responses(barge("", ", depth: 2"), "180", "3,6");
  const double k = 2 * M_PI / number(written[1], "wavelength");
  EXPECT_NEAR(kGravity * k * std::tanh(2 * k), std::pow(2 * M_PI / 6, 2), 1e-9);
  const std::filesystem::path folder = testing::TempDir();
  std::ofstream(folder / "rao_shallow.yaml") << barge("", ", depth: '${depth}'");
  const std::string including =
      "plimsoll: 1\n"
      "variables: {depth: 2}\n"
      "include: " +
      (folder / "rao_shallow.yaml").string() + "\n";
  EXPECT_EQ(responses(including, "180", "3,6"), written);
  EXPECT_EQ(responses(barge("", ", depth: 7"), "180", "3,6", {"--set", "water.depth=2"}), written);
  EXPECT_NE(responses(barge(), "180", "3,6"), written);
}

TEST(RaoCommand, WavesOnACurrentAreThoseAnObserverAtRestMeets) {
  const json with = responses(barge("", ", current: [0.5, 0, 0]"), "0,180", "4");
  for (const json& row : with) {
    const double k = 2 * M_PI / number(row, "wavelength");
    const double along = number(row, "heading_deg") == 0 ? 0.5 : -0.5;
    EXPECT_NEAR(std::sqrt(kGravity * k) + along * k, 2 * M_PI / 4, 1e-9);
  }
  EXPECT_THAT(rao_of({support::write_scene(barge("", ", current: [-9, 0, 0]")), "--headings", "0",
                      "--periods", "2"}),
              HasSubstr("--periods: found 2 s, and the current of -9 m/s stops such a wave"));
}

TEST(RaoCommand, LockedMotionsAreZeroAndSpringsAreFelt) {
  const json locked = responses(barge(", lock: [x, pitch]"), "180", "4");
  EXPECT_EQ(number(locked[0], "surge"), 0);
  EXPECT_EQ(number(locked[0], "pitch_deg"), 0);
  EXPECT_GT(number(locked[0], "heave"), 0.1);
  // A spring along x from 100 m ahead: at this stiffness far above the inertia of surge.
  const std::string spring =
      "springs:\n"
      "  - {name: s, bodies: [barge, world], points: [[0, 0, 0], [100, 0, 0]], stiffness: 1e9}\n";
  const json held = responses(barge() + spring, "180", "4");
  EXPECT_LT(number(held[0], "surge"), 1e-3);
  EXPECT_NEAR(number(held[0], "heave"), number(locked[0], "heave"), 1e-3);
}

// Runs have the loads of linear theory, waves of finite height, and a hull of which they wet more
// or less.
TEST(RaoCommand, AgreesWithRunsInSmallWaves) {
  const json rows = responses(barge(", hydro: {pressure_drag: false, viscous_drag: false}"),
                              "0,180", "3.2,5", {"--runs", "--slope", "0.005"});
  ASSERT_EQ(rows.size(), 8u);
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    const json &linear = rows[i], &run = rows[i + 1];
    EXPECT_EQ(linear["source"], "linear");
    EXPECT_EQ(run["source"], "run");
    EXPECT_EQ(linear["period"], run["period"]);
    for (const char* motion : {"surge", "heave", "pitch_deg"})
      EXPECT_NEAR(number(run, motion) / number(linear, motion), 1, 0.01) << i << motion;
    for (const char* phase : {"surge_phase_deg", "heave_phase_deg", "pitch_phase_deg"})
      EXPECT_NEAR(number(run, phase), number(linear, phase), 2) << i << phase;
  }
}

TEST(RaoCommand, WritesTheSameNumbersAsCsv) {
  const std::string scene = support::write_scene(barge());
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "rao_barge.csv";
  const std::vector<std::string> words = {scene, "--headings", "0:180:45", "--periods", "3:5:0.5"};
  std::vector<std::string> csv = words;
  csv.insert(csv.end(), {"--csv", "--out", file.string(), "--body", "barge"});
  const std::string text = rao_of(csv);
  std::ifstream in(file);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), text);
  EXPECT_EQ(support::lines_of(text).size(), 1u + 5 * 5);
  EXPECT_THAT(text, testing::StartsWith("body,heading_deg,period,omega,wavelength,surge,"
                                        "surge_phase_deg,sway,"));
  EXPECT_THAT(support::lines_of(text)[6], testing::StartsWith("barge,45,3,"));
  const std::string table = rao_of(words);
  EXPECT_THAT(table, HasSubstr("no drag, wind, machines or controls"));
  EXPECT_THAT(table, HasSubstr("deg/m"));
}

TEST(RaoCommand, RefusesWhatIsWrong) {
  const std::string scene = support::write_scene(barge());
  const auto fault = [&](const std::string& option, const std::string& value) {
    return rao_of({scene, option, value});
  };
  EXPECT_THAT(fault("--periods", "0:4:1"), HasSubstr("--periods: found 0, expected positive"));
  EXPECT_THAT(fault("--periods", "4:x:1"), HasSubstr("found 4:x:1, expected FIRST:LAST:STEP"));
  EXPECT_THAT(fault("--periods", "4,3"), HasSubstr("expected numbers that ascend"));
  EXPECT_THAT(fault("--periods", "1:2:1e-9"), HasSubstr("expected at most 1000 numbers"));
  EXPECT_THAT(fault("--periods", "nan"), HasSubstr("expected FIRST:LAST:STEP or A,B,…"));
  EXPECT_THAT(fault("--headings", "180:0:45"),
              HasSubstr("--headings: found 180:0:45, expected FIRST <= LAST and STEP > 0"));
  EXPECT_THAT(fault("--out", "rao.png"), HasSubstr("--out: found rao.png, expected a file .csv"));
  EXPECT_THAT(fault("--slope", "0"), HasSubstr("--slope: found 0, expected a slope above 0"));
  EXPECT_THAT(fault("--body", "bargee"), HasSubstr("did you mean barge?"));
  EXPECT_THAT(fault("--set", "bodies[0].density=1500"),
              HasSubstr("no body has motions by linear theory; barge: "));
  EXPECT_THAT(fault("--set", "bodies[0].hydro={radiation: none}"),
              HasSubstr("barge: its radiation or added_mass is switched off"));
}

}  // namespace
