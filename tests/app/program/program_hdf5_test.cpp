#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/logs/hdf5_file.h"
#include "app/logs/read_log.h"
#include "app/logs/trajectory.h"
#include "tests/app/program/page.h"
#include "tests/app/program/program.h"
#include "tests/support/files.h"

/// `plimsoll run --format hdf5`: what it writes, and what is left where it could not go on. What
/// h5py reads of it: hdf5_test.py.

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::falling_box;
using support::Outcome;
using support::Workplace;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::size_t kChunk = 128;  ///< Rows that wait for one another.
/// Less than the last rows take [bytes].
constexpr std::size_t kCut = 100;

class ProgramHdf5 : public testing::Test {
 protected:
  void SetUp() override {
    if (!app::why_no_hdf5().empty()) GTEST_SKIP() << app::why_no_hdf5();
  }

  Outcome run(std::vector<std::string> more, const std::string& folder = "o") const {
    more.insert(more.begin(), {"run", "box.yaml", "--out", folder, "--format", "hdf5", "--quiet"});
    return here.run(more);
  }

  /// Checks that the log has a row for each step from the first. @return their number
  std::size_t expect_whole_log() const {
    const app::BodyTrack track = app::read_trajectory(here / "o/run.h5").tracks.at("box");
    for (std::size_t i = 0; i < track.times.size(); ++i)
      EXPECT_EQ(track.times[i], static_cast<double>(i) * 0.01);
    return track.times.size();
  }

  /// Starts a run that would take hours and waits until it has written much.
  pid_t start_long_run(const std::string& threads) const {
    here.write("long.yaml", falling_box("1e+7"));
    fs::remove_all(here / "o");
    const pid_t process =
        here.start({"run", "long.yaml", "--out", "o", "--threads", threads, "--format", "hdf5"});
    EXPECT_TRUE(support::wait_for_bytes(here / "o/run.h5", 500'000));
    return process;
  }

  json summary() const { return json::parse(here.read("o/summary.json")); }

  Workplace here;
};

TEST_F(ProgramHdf5, HasTheNumbersOfTheCsvBitByBit) {
  here.write("box.yaml",
             falling_box("3",
                         "  - {name: \"a/b %.ü\", sphere: {radius: 1}, density: 300, position: "
                         "[4, 0, 2], angular_velocity: [1, 2, 3]}\n"));
  ASSERT_EQ(here.run({"run", "box.yaml", "--out", "csv"}).code, 0);
  ASSERT_EQ(run({}).code, 0);
  const Outcome same =
      here.run({"compare", "csv", "o", "--tol",
                "position=0,orientation_deg=0,linear_velocity=0,angular_velocity=0"});
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  const app::Trajectory csv = app::read_trajectory(here / "csv/trajectory.csv");
  const app::Trajectory hdf5 = app::read_trajectory(here / "o/run.h5");
  EXPECT_THAT(hdf5.names, ElementsAre("box", "a/b %.ü"));
  for (const std::string& name : csv.names) {
    ASSERT_EQ(hdf5.tracks.at(name).times, csv.tracks.at(name).times);
    EXPECT_EQ(hdf5.tracks.at(name).times.size(), 301u);
    EXPECT_TRUE(hdf5.tracks.at(name).states == csv.tracks.at(name).states);
  }
}

TEST_F(ProgramHdf5, IsComparedAndAnalysedAsTheCsvIs) {
  here.write("box.yaml",
             falling_box("3", "log: {forces: true, probes: [{name: gauge, wave: [1, 0]}]}\n"));
  ASSERT_EQ(here.run({"run", "box.yaml", "--out", "csv"}).code, 0);
  ASSERT_EQ(run({}).code, 0);
  const Outcome same = here.run({"compare", "csv", "o"});
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  EXPECT_THAT(same.out, HasSubstr("\nforces: "));
  EXPECT_THAT(same.out, HasSubstr("\nprobes: 4 quantities of 1 name, 4 judged, 0 beyond"));
  const json csv = json::parse(here.run({"analyse", "csv", "--json"}).out);
  const json hdf5 = json::parse(here.run({"analyse", "o", "--json"}).out);
  EXPECT_EQ(csv["signals"], hdf5["signals"]);
  EXPECT_EQ(csv["signals"].size(), 7u);  // Six motions and an elevation.
}

TEST_F(ProgramHdf5, HasTheSameNumbersWithAnyNumberOfThreads) {
  here.write("box.yaml", falling_box("3", "log: {forces: true}\n"));
  for (const std::string threads : {"1", "2", "5"})
    ASSERT_EQ(run({"--threads", threads}, threads).code, 0);
  const app::Trajectory once = app::read_trajectory(here / "1/run.h5");
  const auto forces = app::read_forces(here / "1/run.h5");
  ASSERT_TRUE(forces);
  ASSERT_EQ(once.tracks.at("box").times.size(), 301u);
  for (const std::string folder : {"2", "5"}) {
    const app::Trajectory other = app::read_trajectory(here / (folder + "/run.h5"));
    EXPECT_TRUE(other.tracks.at("box").states == once.tracks.at("box").states);
    EXPECT_TRUE(app::read_forces(here / (folder + "/run.h5"))->at("box").columns ==
                forces->at("box").columns);
  }
}

TEST_F(ProgramHdf5, LeavesNoLogOfAnotherFormat) {
  here.write("box.yaml", falling_box("0.2", "log: {forces: true}\n"));
  here.run({"run", "box.yaml", "--out", "o"});
  EXPECT_THAT(support::files_in(here / "o"),
              ElementsAre("forces.csv", "summary.json", "trajectory.csv"));
  run({});
  EXPECT_THAT(support::files_in(here / "o"), ElementsAre("run.h5", "summary.json"));
  EXPECT_EQ(expect_whole_log(), 21u);
  here.run({"run", "box.yaml", "--out", "o"});
  EXPECT_THAT(support::files_in(here / "o"),
              ElementsAre("forces.csv", "summary.json", "trajectory.csv"));
}

TEST_F(ProgramHdf5, IsDrawnAsACsvIs) {
  here.write("box.yaml", falling_box("0.2", "render: {size: [64, 48], every: 0.1}\n"));
  ASSERT_EQ(run({"--no-render"}).code, 0);
  const Outcome outcome = here.run({"render", "o", "--scene", "box.yaml", "--out", "p"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(here / "p/frames/frame_0001.png"));
}

// The same page as of the same run in CSV, but for the wall time.
TEST_F(ProgramHdf5, IsReportedAsACsvIs) {
  support::lay_out_page(here, "page.html");
  const auto page_of = [&](const std::string& folder) {
    const Outcome outcome = here.shell("bin/plimsoll report " + folder);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    json page = support::data_in_page(here.read(folder + "/report.html"));
    page.erase("summary");
    return page;
  };
  const std::string second = "  - {name: ball, sphere: {radius: 1}, density: 300}\n";
  for (const std::string log : {"", "log: {forces: true}\n"}) {
    here.write("box.yaml", falling_box("0.5", second + log));
    ASSERT_EQ(here.run({"run", "box.yaml", "--out", "csv"}).code, 0);
    ASSERT_EQ(run({}).code, 0);
    const json page = page_of("o");
    EXPECT_EQ(page["rows"], 51);
    EXPECT_EQ(page["series"]["forces"], !log.empty());
    EXPECT_TRUE(page == page_of("csv"));
  }
}

TEST_F(ProgramHdf5, KeepsThePastOfABodyThatExplodes) {
  here.write("box.yaml", falling_box("3"));
  for (const std::string threads : support::kWriterThreads) {
    EXPECT_EQ(run({"--threads", threads, "--set",
                   "bodies[0].forces=[{force: [1e+30, 0, 0], start: 2.5}]"})
                  .code,
              3);
    EXPECT_EQ(expect_whole_log(), 251u);
  }
}

TEST_F(ProgramHdf5, KeepsWhatWasDoneBeforeCtrlC) {
  for (const std::string threads : support::kWriterThreads) {
    const pid_t process = start_long_run(threads);
    ::kill(process, SIGINT);
    EXPECT_EQ(here.finish(process).code, 130);
    EXPECT_EQ(expect_whole_log(), summary()["steps"].get<std::size_t>() + 1);
  }
}

// A limit on the size of files stands for a disk that fills up.
TEST_F(ProgramHdf5, KeepsTheRowsBeforeTheDiskWasFull) {
  here.write("box.yaml", falling_box("10000"));
  for (const std::string threads : support::kWriterThreads) {
    const Outcome outcome = here.shell(
        "trap '' XFSZ; ulimit -f 4000; exec $PLIMSOLL run box.yaml --quiet --out o --format hdf5 "
        "--threads " +
        threads);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err, "error: o/run.h5: cannot be written: File too large\n");
    EXPECT_EQ(summary()["ended"], "failed");
    EXPECT_LT(summary()["steps"], 1'000'000);  // it is told long before the end
    EXPECT_GT(expect_whole_log(), kChunk);
    EXPECT_LT(fs::file_size(here / "o/run.h5"), 4000u * 512 + 1);
  }
}

TEST_F(ProgramHdf5, SaysWhenTheDiskIsFullFromTheStart) {
  here.write("box.yaml", falling_box("1"));
  const Outcome outcome = here.shell(
      "trap '' XFSZ; ulimit -f 5; exec $PLIMSOLL run box.yaml --quiet --out o --format hdf5");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err, "error: o/run.h5: cannot be written: File too large\n");
}

TEST_F(ProgramHdf5, ThatIsDamagedIsRefused) {
  here.write("box.yaml", falling_box("5"));
  ASSERT_EQ(run({}).code, 0);
  const std::string whole = here.read("o/run.h5");
  for (const std::size_t length : {std::size_t{8}, whole.size() / 2, whole.size() - kCut}) {
    here.write("cut.h5", whole.substr(0, length));
    const Outcome outcome = here.run({"compare", "cut.h5", "o"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, StartsWith("cut.h5: cannot be read: "));
  }
}

TEST(ProgramFormat, ThatIsUnknownIsRefusedBeforeAnythingIsRun) {
  const Workplace here;
  here.write("box.yaml", falling_box("1"));
  const Outcome outcome = here.run({"run", "box.yaml", "--format", "hdf"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, StartsWith("--format: found hdf, expected csv or hdf5\n"));
  EXPECT_FALSE(fs::exists(here / "out"));
}

TEST(ProgramFormat, WithoutItsLibraryNamesThePackageBeforeAnythingIsRun) {
  if (app::why_no_hdf5().empty()) GTEST_SKIP() << "this program has HDF5";
  const Workplace here;
  here.write("box.yaml", falling_box("1"));
  const Outcome outcome = here.run({"run", "box.yaml", "--format", "hdf5"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, StartsWith("--format hdf5: this plimsoll was built without HDF5; "
                                      "install libhdf5-dev"));
  EXPECT_FALSE(fs::exists(here / "out"));
}

}  // namespace
