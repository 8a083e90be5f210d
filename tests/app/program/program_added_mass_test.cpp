#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/app/program/program.h"
#include "tests/support/tolerance.h"

/// Added mass in scenes, and the store of its solutions.

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::falling_box;
using support::Outcome;
using support::tolerance;
using support::Workplace;
using testing::HasSubstr;

/// No panel is split: a solve of 48 triangles takes some milliseconds.
const std::string kDeep = "bodies[0].hydro.added_mass={tolerance: 1e+3}";

class ProgramAddedMass : public testing::Test {
 protected:
  ProgramAddedMass() { here.write("box.yaml", falling_box("0.5")); }

  Outcome program(std::vector<std::string> words, const std::vector<std::string>& sets) const {
    for (const std::string& set : sets) words.insert(words.end(), {"--set", set});
    return here.run(words, {"PLIMSOLL_CACHE=cache"});
  }
  Outcome run_box(const std::vector<std::string>& sets) const {
    const Outcome outcome = program({"run", "box.yaml", "--out", "o", "--quiet"}, sets);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome;
  }
  json probe(const std::vector<std::string>& sets) const {
    const Outcome outcome = program({"probe", "box.yaml"}, sets);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out)["bodies"]["box"]["added_mass"];
  }
  json of_box() const {
    return json::parse(here.read("o/summary.json"))["bodies"]["box"]["added_mass"];
  }
  std::vector<fs::path> stored() const {
    std::vector<fs::path> files;
    if (fs::exists(here / "cache"))
      for (const auto& entry : fs::directory_iterator(here / "cache")) files.push_back(entry);
    return files;
  }

  Workplace here;
};

TEST_F(ProgramAddedMass, IsSolvedForOnceAndTheSameFromTheStore) {
  EXPECT_EQ(run_box({kDeep}).err, "");
  const json first = of_box();
  const std::string track = here.read("o/trajectory.csv");
  EXPECT_EQ(run_box({kDeep}).err, "");
  const json second = of_box();
  EXPECT_EQ(first["model"], "deep");
  EXPECT_EQ(first["from_store"], false);
  EXPECT_EQ(second["from_store"], true);
  for (const char* key : {"matrix", "symmetry_error", "error_estimate", "solve_seconds"})
    EXPECT_EQ(first[key], second[key]) << key;
  EXPECT_EQ(here.read("o/trajectory.csv"), track);
  EXPECT_EQ(stored().size(), 1);
  // A cube's is 0.638 of the water that it displaces; 48 triangles are coarse.
  EXPECT_NEAR(first["matrix"][2][2], 638, tolerance(60));
}

TEST_F(ProgramAddedMass, OfASecondRunNearTheSurfaceNeedsNoSolve) {
  const std::string surface = "bodies[0].hydro.added_mass={model: surface}";
  const std::vector<std::string> sets = {surface, "bodies[0].position=[0, 0, -0.2]",
                                         "duration=0.1"};
  run_box(sets);
  EXPECT_GT(of_box()["solves"], 0);
  const std::string track = here.read("o/trajectory.csv");
  run_box(sets);
  EXPECT_EQ(of_box()["model"], "surface");
  EXPECT_EQ(of_box()["solves"], 0);
  EXPECT_EQ(here.read("o/trajectory.csv"), track);
}

TEST_F(ProgramAddedMass, IsTheSameForAnyNumberOfThreads) {
  std::vector<json> matrices;
  std::vector<std::string> tracks;
  for (const std::string threads : {"1", "3"}) {
    const std::vector<std::string> words = {"run",       "box.yaml", "--out", "o",
                                            "--threads", threads,    "--set", kDeep};
    EXPECT_EQ(here.run(words, {"PLIMSOLL_CACHE=cache" + threads}).code, 0);
    EXPECT_EQ(of_box()["from_store"], false);
    matrices.push_back(of_box()["matrix"]);
    tracks.push_back(here.read("o/trajectory.csv"));
  }
  EXPECT_EQ(matrices[0], matrices[1]);
  EXPECT_EQ(tracks[0], tracks[1]);
}

TEST_F(ProgramAddedMass, IsOneSolutionForAllDensitiesCentresAndBodiesOfAMesh) {
  run_box({kDeep});
  const std::string more =
      "bodies=[{name: a, box: {size: [1, 1, 1], divisions: 2}, density: 300}, "
      "{name: b, box: {size: [1, 1, 1], divisions: 2}, mass: 9, "
      "center_of_mass: [0.1, 0, 0], position: [5, 0, 0]}]";
  run_box({more, "hydro.added_mass={tolerance: 1e+3}", "water.density=1025"});
  EXPECT_EQ(stored().size(), 1);
  const json bodies = json::parse(here.read("o/summary.json"))["bodies"];
  EXPECT_EQ(bodies["a"]["added_mass"]["from_store"], true);
  // About a point 0.1 m off its middle sway turns the cube: A_26 = −0.1 m · A_22.
  const json& b = bodies["b"]["added_mass"];
  EXPECT_EQ(b["from_store"], true);
  const double sway = b["matrix"][1][1];
  EXPECT_NEAR(b["matrix"][1][5], -0.1 * sway, tolerance(1e-4) * sway);
}

TEST_F(ProgramAddedMass, IsNotSolvedForWhereNothingNeedsIt) {
  const std::string default_model = "bodies[0].hydro={}";
  run_box({"bodies[0].hydro.added_mass=none"});
  EXPECT_EQ(of_box(), nullptr);
  run_box({default_model, "bodies[0].lock=all"});
  EXPECT_EQ(of_box(), nullptr);
  run_box({"bodies[0].hydro={buoyancy: false, pressure_drag: 0, lift: 0, viscous_drag: 0}"});
  EXPECT_EQ(of_box(), nullptr);
  EXPECT_EQ(program({"check", "box.yaml"}, {default_model}).code, 0);
  here.write("dry.yaml",
             "plimsoll: 1\nduration: 0.1\nbodies: [{name: a, box: {size: [1, 1, 1]}, density: 1}]");
  EXPECT_EQ(program({"run", "dry.yaml"}, {}).code, 0);
  EXPECT_TRUE(probe({"bodies[0].hydro.added_mass=none"}).is_null());
  EXPECT_FALSE(fs::exists(here / "cache"));
}

TEST_F(ProgramAddedMass, IsSolvedForAHeldBodyWhoseForcesAreLogged) {
  run_box({"bodies[0].lock=all", kDeep, "log={forces: true}"});
  EXPECT_GT(of_box()["matrix"][2][2], 0);
}

TEST_F(ProgramAddedMass, IsThatOfTheWettedPart) {
  EXPECT_EQ(probe({kDeep, "bodies[0].position=[0, 0, 5]"})[2][2], 0);
  const json whole = probe({kDeep, "bodies[0].position=[0, 0, -5]"});
  const json half = probe({kDeep, "bodies[0].position=[0, 0, 0]"});
  const json other = probe(
      {kDeep, "bodies[0].position=[0, 0, 0]", "bodies[0].orientation={euler_deg: [180, 0, 0]}"});
  ASSERT_EQ(whole.size(), 6);
  const double heave = whole[2][2];
  // Both halves are the whole, but for what little of heave is in the negative eigenvalues: the
  // cube's faces are divided unevenly by some parts in a thousand, which counts squared.
  EXPECT_NEAR(double(half[2][2]) + double(other[2][2]), heave, tolerance(1e-5) * heave);
  EXPECT_NEAR(half[2][2], heave / 2, tolerance(1e-2) * heave);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) EXPECT_EQ(half[i][j], half[j][i]);
}

TEST_F(ProgramAddedMass, OfAMatrixIsTurnedIntoWorldAxes) {
  const std::string matrix =
      "bodies[0].hydro.added_mass={matrix: [[1, 0, 0, 0, 0, 0], [0, 2, 0, 0, 0, 0], "
      "[0, 0, 3, 0, 0, 0], [0, 0, 0, 4, 0, 0], [0, 0, 0, 0, 5, 0], [0, 0, 0, 0, 0, 6]]}";
  const std::vector<std::string> afloat = {matrix, "bodies[0].position=[0, 0, 0]",
                                           "bodies[0].orientation={euler_deg: [0, 0, 90]}"};
  const json turned = probe(afloat);
  const std::vector<double> expected = {2, 1, 3, 5, 4, 6};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(turned[i][i], expected[i], tolerance(1e-14)) << i;
  run_box(afloat);
  EXPECT_EQ(of_box()["model"], "matrix");
  EXPECT_EQ(of_box()["matrix"][4][4], 5);
  EXPECT_EQ(probe({matrix})[0][0], 0);  // it starts above the water
  EXPECT_FALSE(fs::exists(here / "cache"));
}

TEST_F(ProgramAddedMass, IsFoundAnewWhereTheStoreIsDamaged) {
  run_box({kDeep});
  const json first = of_box();
  fs::resize_file(stored().at(0), 1000);
  EXPECT_THAT(run_box({kDeep}).err, testing::MatchesRegex("warning: cache/.* is damaged: 1000 "
                                                          "bytes, expected .*\n"));
  EXPECT_EQ(of_box()["from_store"], false);
  EXPECT_EQ(of_box()["matrix"], first["matrix"]);
  EXPECT_EQ(run_box({kDeep}).err, "");
  EXPECT_EQ(of_box()["from_store"], true);
}

TEST_F(ProgramAddedMass, OfACommandComesFromTheSameStore) {
  const std::vector<std::string> words = {"addedmass", "box.yaml", "--tolerance", "1e+3", "--json"};
  const auto from_store = [&](std::vector<std::string> more) {
    more.insert(more.begin(), words.begin(), words.end());
    const Outcome outcome = program(more, {});
    EXPECT_EQ(outcome.err, "");
    return json::parse(outcome.out)["bodies"]["box"]["from_store"].get<bool>();
  };
  EXPECT_FALSE(from_store({"--no-store"}));
  EXPECT_TRUE(stored().empty());
  run_box({kDeep});
  EXPECT_TRUE(from_store({}));
  EXPECT_FALSE(from_store({"--no-store"}));
}

}  // namespace
