#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "app/logs/read_log.h"
#include "app/logs/rig_log.h"
#include "tests/app/program/program.h"
#include "tests/support/files.h"
#include "tests/support/repeats.h"
#include "tests/support/tolerance.h"

/// Scenes with `moorings: {moordyn: FILE}`.

namespace {

using support::Outcome;
using support::Workplace;
using testing::HasSubstr;
using testing::StartsWith;

std::string scene(const std::string& duration, const std::string& moorings) {
  return "plimsoll: 1\nduration: " + duration +
         "\nstep: 0.02\n"
         "water: {density: 1025, depth: 50}\n"
         "bodies:\n"
         "  - {name: buoy, sphere: {radius: 1.5}, density: 400, position: [0, 0, 0.2],\n"
         "     linear_velocity: [0.5, 0, 0], hydro: {added_mass: none}}\n"
         "  - {name: crate, box: {size: [1, 1, 1]}, density: 500, position: [9, 0, 0],\n"
         "     hydro: {added_mass: none}}\n"
         "moorings: " +
         moorings + "\n";
}

/// A file of two chains on the buoy.
const std::string kChains =
    "--- LINE TYPES ---\n"
    "Name Diam Mass EA BA EI Cd Ca CdAx CaAx\n"
    "(-) (m) (kg/m) (N) (N-s) (N-m2) (-) (-) (-) (-)\n"
    "chain 0.05 60 1e7 -0.8 0 1.2 1.0 0.05 0\n"
    "--- POINTS ---\n"
    "ID Type X Y Z M V CdA Ca\n"
    "(-) (-) (m) (m) (m) (kg) (m3) (m2) (-)\n"
    "1 Fixed -70 0 -50 0 0 0 0\n"
    "2 Fixed 70 0 -50 0 0 0 0\n"
    "3 Coupled -1 0 -1 0 0 0 0\n"
    "4 Coupled 1 0 -1 0 0 0 0\n"
    "--- LINES ---\n"
    "ID Type A B Length Segments Outputs\n"
    "(-) (-) (-) (-) (m) (-) (-)\n"
    "1 chain 1 3 95 10 -\n"
    "2 chain 2 4 95 10 -\n"
    "--- OPTIONS ---\n"
    "0.02 cfl\n";

class ProgramMoorDyn : public testing::Test {
 protected:
  void SetUp() override { here.write("chains.txt", kChains); }

  const Workplace here;
};

TEST_F(ProgramMoorDyn, LogsItsLinesAndTellsOfThem) {
  here.write("scene.yaml", scene("2", "{moordyn: chains.txt, bodies: [buoy]}"));
  const Outcome outcome = here.run({"run", "scene.yaml", "--out", "o", "--quiet"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(support::files_in(here / ""),
            (std::vector<std::string>{"chains.txt", "err.txt", "o", "out.txt", "scene.yaml"}));
  const auto lines = app::read_table(here / "o/trajectory.csv", app::lines_layout());
  ASSERT_TRUE(lines);
  for (const char* name : {"moorings[1]", "moorings[2]"}) {
    const app::TableTrack& track = lines->tracks.at(name);
    ASSERT_EQ(track.times.size(), 101u);
    EXPECT_GT(track.columns[lines->layout.column("tension")].back(), 1e4);
    EXPECT_EQ(track.columns[lines->layout.column("length")].back(), 95);
  }
  const auto nodes = app::read_table(here / "o/trajectory.csv", app::line_nodes_layout());
  ASSERT_TRUE(nodes);
  EXPECT_EQ(nodes->names.size(), 22u);
  const std::vector<double> heights = nodes->tracks.at("moorings[1].10").columns[2];
  EXPECT_NEAR(heights.back(), -50, support::tolerance(0.1));  // The anchor lies on the ground.
  const nlohmann::json summary = nlohmann::json::parse(here.read("o/summary.json"));
  EXPECT_EQ(summary["moorings"], "dynamic");
  EXPECT_GT(summary["lines"]["moorings[2]"]["tension_max"], 1e4);
  EXPECT_FALSE(summary["skipped"]["lines"]);
}

TEST_F(ProgramMoorDyn, FaultsAreToldAtTheirKeys) {
  const auto changed = [](const std::string& text, const std::string& by) {
    std::string file = kChains;
    return file.replace(file.find(text), text.size(), by);
  };
  here.write("empty.txt", "\n");
  here.write("body.txt",
             changed("--- LINES", "--- BODIES ---\nID Type\n(-) (-)\n1 Coupled\n--- LINES"));
  here.write("free.txt", changed("2 Fixed", "2 Free"));
  here.write("type.txt", changed("2 chain", "2 rope"));
  here.write("number.txt", changed("1e7", "1e7|2e7"));
  for (const auto& [moorings, fault] : std::vector<std::pair<std::string, std::string>>{
           {"{moordyn: chains.txt, bodies: [buoy, crate, buoy]}",
            "10:41: moorings.bodies: found a list of 3, expected one name, or one for each of the "
            "2 coupled points of the file"},
           {"{moordyn: empty.txt, bodies: [buoy]}",
            "10:21: moorings.moordyn: it has no section LINES with a line"},
           {"{moordyn: body.txt, bodies: [buoy]}",
            "10:21: moorings.moordyn: line 15: rods, bodies and failures are not supported"},
           {"{moordyn: free.txt, bodies: [buoy]}",
            "10:21: moorings.moordyn: line 9: found a point of the type Free, expected Fixed or "
            "Coupled"},
           {"{moordyn: type.txt, bodies: [buoy]}",
            "10:21: moorings.moordyn: line 16: there is no line type rope"},
           {"{moordyn: number.txt, bodies: [buoy]}",
            "10:21: moorings.moordyn: line 4: found 1e7|2e7 for EA, expected a number"}}) {
    const Outcome outcome = here.run({"check", here.write("scene.yaml", scene("1", moorings))});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, StartsWith("scene.yaml:" + fault));
  }
}

TEST_F(ProgramMoorDyn, WhatIsLeftOutIsWarnedOf) {
  std::string stiff = kChains;
  here.write("stiff.txt", stiff.replace(stiff.find("-0.8 0 "), 7, "-0.8 9 "));
  const Outcome outcome = here.run(
      {"check", here.write("scene.yaml", scene("1", "{moordyn: stiff.txt, bodies: [buoy]}"))});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out + outcome.err,
              HasSubstr("moorings.moordyn: the bending stiffness EI of the file is left out"));
}

TEST_F(ProgramMoorDyn, AKilledRunGoesOnAsOneThatIsNotStopped) {
  const std::string file = here.write(
      "scene.yaml",
      scene(std::to_string(support::repeats(60)), "{moordyn: chains.txt, bodies: [buoy, crate]}"));
  ASSERT_EQ(here.run({"run", file, "--out", "whole", "--quiet"}).code, 0);
  const pid_t process = here.start({"run", file, "--out", "cut", "--checkpoint", "0.01"});
  EXPECT_TRUE(support::wait_for_bytes(here / "cut/checkpoint.bin", 100));
  EXPECT_TRUE(support::wait_for_bytes(here / "cut/trajectory.csv", 10000));
  ::kill(process, SIGKILL);
  ASSERT_EQ(here.finish(process).code, -SIGKILL);
  const Outcome resumed = here.run({"run", "--resume", "cut"});
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  const app::Trajectory a = app::read_trajectory(here / "whole/trajectory.csv"),
                        b = app::read_trajectory(here / "cut/trajectory.csv");
  for (const char* name : {"buoy", "crate"}) {
    ASSERT_EQ(a.tracks.at(name).times, b.tracks.at(name).times);
    EXPECT_EQ(a.tracks.at(name).states.back().position, b.tracks.at(name).states.back().position);
  }
}

TEST_F(ProgramMoorDyn, ARunWhoseFileHasChangedIsNotResumed) {
  const std::string file =
      here.write("scene.yaml", scene("1000", "{moordyn: chains.txt, bodies: [buoy]}"));
  const pid_t process = here.start({"run", file, "--out", "cut", "--checkpoint", "0.01"});
  EXPECT_TRUE(support::wait_for_bytes(here / "cut/checkpoint.bin", 100));
  ::kill(process, SIGTERM);
  ASSERT_EQ(here.finish(process).code, 130);
  std::string heavier = kChains;
  here.write("chains.txt", heavier.replace(heavier.find(" 60 "), 4, " 61 "));
  const Outcome resumed = here.run({"run", "--resume", "cut"});
  EXPECT_EQ(resumed.code, 2);
  EXPECT_THAT(resumed.err, HasSubstr("has changed since the checkpoint"));
}

}  // namespace
