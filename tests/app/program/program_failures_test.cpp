#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/logs/read_log.h"
#include "app/logs/trajectory.h"
#include "tests/app/program/program.h"
#include "tests/support/files.h"

/// What the program does when it cannot do what it was asked for: exit codes, messages, and what is
/// left on disk.

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::falling_box;
using support::Outcome;
using support::Workplace;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class ProgramFailures : public testing::Test {
 protected:
  /// Starts a run that would take hours and waits until it has logged some rows.
  pid_t start_long_run(const std::string& more = "", const std::string& threads = "2") {
    here.write("long.yaml", falling_box("1e+7", more));
    fs::remove_all(here / "o");  // another run's log would be taken for this one's
    const pid_t process = here.start({"run", "long.yaml", "--out", "o", "--threads", threads});
    EXPECT_TRUE(support::wait_for_bytes(here / "o/trajectory.csv", 20'000));
    return process;
  }

  /// Checks that the long run's log has a row for each step from the first.
  std::size_t expect_whole_log() {
    const app::BodyTrack track = app::read_trajectory(here / "o/trajectory.csv").tracks.at("box");
    for (std::size_t i = 0; i < track.times.size(); ++i)
      EXPECT_EQ(track.times[i], static_cast<double>(i) * 0.01);
    return track.times.size();
  }

  json summary() const { return json::parse(here.read("o/summary.json")); }

  Workplace here;
};

TEST_F(ProgramFailures, WrongUsageIsCodeTwoAndSaysWhatIsRight) {
  const Outcome nothing = here.run({});
  EXPECT_EQ(nothing.code, 2);
  EXPECT_THAT(nothing.err, StartsWith("found nothing, expected a command: run, new, check, "));
  const Outcome command = here.run({"fly", "x.yaml"});
  EXPECT_EQ(command.code, 2);
  EXPECT_THAT(command.err, StartsWith("found fly, expected a command: run, new, check, "));
  here.write("box.yaml", falling_box("1"));
  const Outcome option = here.run({"run", "box.yaml", "--nope"});
  EXPECT_EQ(option.code, 2);
  EXPECT_THAT(option.err, HasSubstr("--nope"));
  EXPECT_EQ(here.run({"run"}).code, 2);
  EXPECT_EQ(here.run({"run", "box.yaml", "--threads", "0"}).code, 2);
  EXPECT_EQ(here.run({"run", "box.yaml", "box.yaml"}).code, 2);
  EXPECT_EQ(here.run({"run", "box.yaml", "--set", "duration"}).code, 2);
  EXPECT_FALSE(fs::exists(here / "out"));
}

TEST_F(ProgramFailures, AMisspeltOptionNamesTheNearest) {
  const Outcome outcome = here.run({"run", "box.yaml", "--ouut", "o"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, StartsWith("plimsoll run has no option --ouut; did you mean --out?\n"));
}

TEST_F(ProgramFailures, HelpAndVersionAreNoFailures) {
  const Outcome help = here.run({"--help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_THAT(help.out, HasSubstr("Usage: plimsoll"));
  EXPECT_THAT(here.run({"--version"}).out, StartsWith("plimsoll "));
}

TEST_F(ProgramFailures, AWrongSceneRunsNothing) {
  here.write("wrong.yaml", "plimsoll: 1\nduration: -1\nstepp: 1\nbodies: 3\n");
  const Outcome outcome = here.run({"run", "wrong.yaml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(support::lines_of(outcome.err).size(), 4u);
  EXPECT_THAT(outcome.err, StartsWith("wrong.yaml:2:11: duration: found -1"));
  EXPECT_THAT(outcome.err, EndsWith("\n3 problems, nothing was run.\n"));
  EXPECT_FALSE(fs::exists(here / "out"));
}

TEST_F(ProgramFailures, ASceneThatIsNotThereIsNamed) {
  EXPECT_EQ(here.run({"run", "none.yaml"}).err,
            "none.yaml: there is no such file\n1 problem, nothing was run.\n");
  EXPECT_EQ(here.run({"run", "."}).err,
            ".: found a folder, expected a file\n1 problem, nothing was run.\n");
}

TEST_F(ProgramFailures, AFolderThatCannotBeMadeIsNamed) {
  here.write("box.yaml", falling_box("0.1"));
  here.write("file", "");
  for (const std::string out : {"file", "file/x", "/proc/x"}) {
    const Outcome outcome = here.run({"run", "box.yaml", "--out", out});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, StartsWith(out + ": cannot be made: "));
  }
}

TEST_F(ProgramFailures, ABodyThatExplodesIsNamedAndItsPastIsKept) {
  const std::string push = "bodies[0].forces=[{force: [1e+30, 0, 0], start: 0.5}]";
  here.write("box.yaml", falling_box("1"));
  for (const std::string threads : support::kWriterThreads) {
    const Outcome outcome =
        here.run({"run", "box.yaml", "--out", "o", "--quiet", "--threads", threads, "--set", push});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, StartsWith("error: body 'box' at t = 0.5 s: "));
    EXPECT_EQ(expect_whole_log(), 51u);
    EXPECT_EQ(summary()["ended"], "failed");
    EXPECT_EQ("error: " + std::string(summary()["error"]) + "\n", outcome.err);
    EXPECT_EQ(summary()["steps"], 50);
  }
}

TEST_F(ProgramFailures, ALogThatCannotBeWrittenComesBeforeALaterExplosion) {
  const std::string push = "bodies[0].forces=[{force: [1e+30, 0, 0], start: 0.02}]";
  here.write("box.yaml", falling_box("1"));
  fs::create_directories(here / "o");
  fs::create_symlink("/dev/full", here / "o/trajectory.csv");
  for (const std::string threads : support::kWriterThreads) {
    const Outcome outcome =
        here.run({"run", "box.yaml", "--out", "o", "--threads", threads, "--set", push});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(support::after_scene(outcome.err),
                StartsWith("error: o/trajectory.csv: cannot be written: "));
  }
}

TEST_F(ProgramFailures, AnExplosionIsDrawnUpToThere) {
  const std::string push = "bodies[0].forces=[{force: [1e+30, 0, 0], start: 0.5}]";
  here.write("box.yaml", falling_box("1", "render: {size: [64, 48], every: 0.25}\n"));
  EXPECT_EQ(here.run({"run", "box.yaml", "--out", "o", "--set", push}).code, 3);
  EXPECT_EQ(summary()["pictures"]["frames"], 3);
}

TEST_F(ProgramFailures, CtrlCKeepsWhatWasDone) {
  for (const std::string threads : support::kWriterThreads) {
    const pid_t process = start_long_run("", threads);
    ::kill(process, SIGINT);
    const Outcome outcome = here.finish(process);
    EXPECT_EQ(outcome.code, 130);
    EXPECT_THAT(support::after_scene(outcome.err), HasSubstr("interrupted at "));
    EXPECT_EQ(summary()["ended"], "interrupted");
    EXPECT_EQ(expect_whole_log(), summary()["steps"].get<std::size_t>() + 1);
  }
}

/// Bodies of which a step takes many seconds: loads of short waves on long faces.
std::string slow_scene() {
  return R"(plimsoll: 1
duration: 10
step: 0.01
water: {surface: {spectrum: {type: jonswap, significant_height: 0.03, peak_period: 0.6, components: 256}}}
hydro: {added_mass: none, wave_tolerance: 1e-6}
bodies:
  - {name: b, repeat: {grid: [40, 40, 1], spacing: [60, 60, 0]}, box: {size: [40, 10, 6]}, density: 500, position: [0, 0, 0]}
)";
}

TEST_F(ProgramFailures, CtrlCLeavesASlowStepAndItsLogIsWhole) {
  here.write("slow.yaml", slow_scene());
  const pid_t process = here.start({"run", "slow.yaml", "--out", "o", "--checkpoint", "1000"});
  ASSERT_TRUE(support::wait_for_bytes(here / "o/trajectory.csv", 60'000));
  ::kill(process, SIGINT);
  EXPECT_EQ(here.finish(process).code, 130);
  // The step would take many seconds: it was left.
  EXPECT_EQ(summary()["steps"], 0);
  EXPECT_EQ(app::read_trajectory(here / "o/trajectory.csv").tracks.at("b_7").times.size(), 1u);
  EXPECT_TRUE(fs::exists(here / "o/checkpoint.bin"));
}

TEST_F(ProgramFailures, AKilledRunLeavesEveryRowItHadLogged) {
  const pid_t process = start_long_run();
  const auto logged = fs::file_size(here / "o/trajectory.csv");
  ::kill(process, SIGKILL);
  EXPECT_EQ(here.finish(process).code, -SIGKILL);
  EXPECT_GE(fs::file_size(here / "o/trajectory.csv"), logged);
  EXPECT_GT(expect_whole_log(), 50u);
  EXPECT_FALSE(fs::exists(here / "o/summary.json"));
}

/// Numbers of fields of a CSV file's whole lines.
std::vector<std::ptrdiff_t> widths_of(const std::string& csv) {
  std::vector<std::ptrdiff_t> widths;
  for (const std::string& line : support::lines_of(csv.substr(0, csv.rfind('\n') + 1)))
    widths.push_back(1 + std::count(line.begin(), line.end(), ','));
  return widths;
}

TEST_F(ProgramFailures, AKilledRunLeavesTheForcesOfEveryRowButTheLast) {
  const pid_t process = start_long_run("log: {forces: true}\n");
  ::kill(process, SIGKILL);
  here.finish(process);
  const std::vector<std::ptrdiff_t> widths = widths_of(here.read("o/forces.csv"));
  EXPECT_GE(widths.size(), expect_whole_log());  // with the header
  EXPECT_THAT(widths, testing::Each(134));
}

TEST_F(ProgramFailures, ASecondRunDoesNotMixItsFilesWithThoseOfTheFirst) {
  const pid_t first = start_long_run();
  here.write("box.yaml", falling_box("0.1"));
  const Outcome second = here.shell("$PLIMSOLL run box.yaml --out o");
  EXPECT_EQ(second.code, 2);
  EXPECT_THAT(second.err, StartsWith("o: another run is writing to this folder"));
  ::kill(first, SIGTERM);
  EXPECT_EQ(here.finish(first).code, 130);
  EXPECT_GT(expect_whole_log(), 11u);
  EXPECT_EQ(here.run({"run", "box.yaml", "--out", "o"}).code, 0);
}

TEST_F(ProgramFailures, AFullDiskIsToldAtTheFirstRowLost) {
  here.write("box.yaml", falling_box("1"));
  for (const std::string log : {"trajectory.csv", "forces.csv"})
    for (const std::string threads : support::kWriterThreads) {
      fs::remove_all(here / "o");
      fs::create_directories(here / "o");
      fs::create_symlink("/dev/full", here / "o" / log);
      const Outcome outcome = here.run(
          {"run", "box.yaml", "--out", "o", "--threads", threads, "--set", "log.forces=true"});
      EXPECT_EQ(outcome.code, 2);
      EXPECT_THAT(support::after_scene(outcome.err),
                  StartsWith("error: o/" + log + ": cannot be written: No space left on device\n"));
      EXPECT_EQ(summary()["ended"], "failed");
    }
}

// A limit on the size of files stands for a disk that fills up: both make a write come short.
TEST_F(ProgramFailures, ADiskThatFillsUpKeepsTheRowsBefore) {
  here.write("box.yaml", falling_box("100"));
  for (const std::string threads : support::kWriterThreads) {
    const Outcome outcome =
        here.shell("ulimit -f 16; exec $PLIMSOLL run box.yaml --out o --threads " + threads);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(support::after_scene(outcome.err),
                StartsWith("error: o/trajectory.csv: cannot be written: File too large"));
    EXPECT_EQ(summary()["ended"], "failed");
    const auto steps = summary()["steps"].get<std::size_t>();
    const std::size_t rows = expect_whole_log();
    EXPECT_GE(rows, threads == "1" ? steps : 10);
    EXPECT_LE(rows, steps);
    EXPECT_LT(steps, 10'000u);  // it is told long before the end
  }
}

TEST_F(ProgramFailures, APictureThatCannotBeWrittenIsTheLast) {
  here.write("box.yaml", falling_box("0.2", "render: {size: [640, 480], every: 0.02}\n"));
  for (const std::string threads : support::kWriterThreads) {
    const Outcome outcome =
        here.shell("ulimit -f 32; exec $PLIMSOLL run box.yaml --out o --threads " + threads);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(support::after_scene(outcome.err),
                StartsWith("error: o/frames/frame_0000.png: cannot write the picture: "));
    EXPECT_EQ(summary()["skipped"]["pictures"], "they could not be drawn");
    EXPECT_FALSE(fs::exists(here / "o/frames/frame_0001.png"));
    EXPECT_FALSE(fs::exists(here / "o/sheet.png"));
    EXPECT_EQ(expect_whole_log(), 21u);
  }
}

TEST_F(ProgramFailures, AFolderThatIsRemovedMeanwhileIsToldAndNotMadeAnew) {
  for (const std::string threads : support::kWriterThreads) {
    const pid_t process = start_long_run("", threads);
    fs::remove_all(here / "o");
    ::kill(process, SIGINT);
    const Outcome outcome = here.finish(process);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err,
                EndsWith("\nerror: o: cannot be written: it was removed or replaced during the "
                         "run\n"));
    EXPECT_FALSE(fs::exists(here / "o"));
  }
}

TEST_F(ProgramFailures, ALogThatIsReplacedMeanwhileIsTold) {
  for (const std::string threads : support::kWriterThreads) {
    const pid_t process = start_long_run("", threads);
    fs::rename(here / "o/trajectory.csv", here / "o/moved.csv");
    here.write("o/trajectory.csv", "another\n");
    ::kill(process, SIGINT);
    const Outcome outcome = here.finish(process);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err,
                HasSubstr("\nerror: o/trajectory.csv: cannot be written: it was removed "
                          "or replaced during the run\n"));
    EXPECT_EQ(summary()["ended"], "failed");
    EXPECT_EQ(here.read("o/trajectory.csv"), "another\n");
  }
}

TEST_F(ProgramFailures, WhatAKilledRunLeftInPartIsRemovedByTheNext) {
  here.write("box.yaml", falling_box("0.1", "render: {size: [64, 48]}\n"));
  here.write("o/summary.json.part-999999999-0", "{");
  here.write("o/box.mp4.part-999999999-1", "");
  here.write("o/frames/frame_0007.png.part-999999999", "");
  here.write("o/my.csv.part-one", "");
  const Outcome outcome = here.run({"run", "box.yaml", "--out", "o", "--quiet"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(support::files_in(here / "o"),
              testing::ElementsAre("frames", "my.csv.part-one", "sheet.png", "summary.json",
                                   "trajectory.csv"));
  for (const std::string& frame : support::files_in(here / "o/frames"))
    EXPECT_THAT(frame, EndsWith(".png"));
}

TEST_F(ProgramFailures, OutputThatCannotBeWrittenIsTold) {
  here.write("box.yaml", falling_box("1"));
  EXPECT_EQ(here.shell("$PLIMSOLL probe box.yaml >/dev/full").code, 2);
  EXPECT_EQ(here.shell("$PLIMSOLL check box.yaml >/dev/full").code, 2);
}

TEST_F(ProgramFailures, WithoutGraphicsTheMotionIsStillThere) {
  here.write("box.yaml", falling_box("0.5", "render: {size: [64, 48]}\n"));
  const Outcome outcome =
      here.run({"run", "box.yaml", "--out", "o"},
               {"__EGL_VENDOR_LIBRARY_DIRS=/nonexistent", "__EGL_VENDOR_LIBRARY_FILENAMES="});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(support::after_scene(outcome.err), StartsWith("error: "));
  EXPECT_EQ(expect_whole_log(), 51u);
  EXPECT_EQ(summary()["skipped"]["pictures"], "they could not be drawn");
}

}  // namespace
