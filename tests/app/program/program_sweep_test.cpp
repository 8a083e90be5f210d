#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/app/program/program.h"

/// What `plimsoll sweep` does, leaves behind and goes on from.

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::falling_box;
using support::lines_of;
using support::Outcome;
using support::Workplace;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class ProgramSweep : public testing::Test {
 protected:
  ProgramSweep() { here.write("box.yaml", falling_box("0.2")); }

  static std::vector<std::string> command(const std::string& out,
                                          const std::vector<std::string>& more) {
    std::vector<std::string> words = {"sweep", "box.yaml", "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  Outcome sweep(const std::string& out, const std::vector<std::string>& more) const {
    return here.run(command(out, more), {"PLIMSOLL_CACHE=cache"});
  }
  fs::path run_file(const std::string& out, const std::string& run, const std::string& file) const {
    return here / (out + "/runs/" + run + "/" + file);
  }

  /// The lines of the table without the wall times, which differ from run to run.
  std::vector<std::string> table(const std::string& out) const {
    std::vector<std::string> lines = lines_of(here.read(out + "/sweep.csv"));
    // The values of these tests hold no commas: before it are the run, two values, the exit code
    // and the simulated time.
    constexpr int kBefore = 5;
    for (std::string& line : lines) {
      std::size_t start = 0;
      for (int i = 0; i < kBefore; ++i) start = line.find(',', start) + 1;
      line.erase(start, line.find(',', start) - start);
    }
    return lines;
  }
  std::vector<std::string> column(const std::string& out, std::size_t index) const {
    std::vector<std::string> cells;
    for (const std::string& line : lines_of(here.read(out + "/sweep.csv"))) {
      std::istringstream stream(line);
      std::string cell;
      for (std::size_t i = 0; i <= index; ++i) std::getline(stream, cell, ',');
      cells.push_back(cell);
    }
    return cells;
  }

  /// Starts a sweep of a run of 0.2 s and one that would take hours, and waits for the latter.
  pid_t start_endless(const std::string& out) const {
    fs::remove_all(here / out);
    const pid_t process = here.start(command(out, kEndless));
    EXPECT_TRUE(support::wait_for_bytes(run_file(out, "0001", "trajectory.csv"), 20'000));
    return process;
  }

  const std::vector<std::string> kGrid = {"--vary", "bodies[0].density=300:500:200", "--vary",
                                          "bodies[box].box.divisions=1,2"};
  const std::vector<std::string> kEndless = {"--vary", "duration=0.2,1e+7", "-j", "1"};
  Workplace here;
};

/// All words in one list.
std::vector<std::string> operator+(std::vector<std::string> words,
                                   const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST_F(ProgramSweep, RunsAllCombinationsAsRunWould) {
  const Outcome outcome = sweep("o", kGrid);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "o: 4 of 4 runs are done; the table is sweep.csv\n");
  EXPECT_THAT(column("o", 0), ElementsAre("run", "0000", "0001", "0002", "0003"));
  EXPECT_THAT(column("o", 1), ElementsAre("bodies[0].density", "300", "300", "500", "500"));
  EXPECT_THAT(column("o", 2), ElementsAre("bodies[box].box.divisions", "1", "2", "1", "2"));
  EXPECT_THAT(column("o", 3), ElementsAre("exit_code", "0", "0", "0", "0"));
  EXPECT_THAT(column("o", 4), ElementsAre("simulated_seconds", "0.2", "0.2", "0.2", "0.2"));
  here.run({"run", "box.yaml", "--out", "alone", "--set", "bodies[0].density=500", "--set",
            "bodies[0].box.divisions=1"});
  EXPECT_EQ(here.read("o/runs/0002/trajectory.csv"), here.read("alone/trajectory.csv"));
  EXPECT_EQ(json::parse(here.read("o/runs/0002/summary.json"))["threads"], 1);
  const std::string last_row = lines_of(here.read("alone/trajectory.csv")).back();
  const std::string last_z = [&] {
    std::istringstream stream(last_row);
    std::string cell;
    for (int i = 0; i < 5; ++i) std::getline(stream, cell, ',');
    return cell;
  }();
  EXPECT_EQ(column("o", 8)[0], "box.z");
  EXPECT_EQ(column("o", 8)[3], last_z);
}

TEST_F(ProgramSweep, TheTableDoesNotDependOnHowManyRunAtATime) {
  EXPECT_EQ(sweep("a", kGrid + std::vector<std::string>{"-j", "1"}).code, 0);
  EXPECT_EQ(sweep("b", kGrid + std::vector<std::string>{"-j", "2"}).code, 0);
  EXPECT_THAT(table("a"), testing::SizeIs(5));
  EXPECT_EQ(table("a"), table("b"));
}

TEST_F(ProgramSweep, SamplesARangeAtAnyNumberOfIt) {
  const std::vector<std::string> words = {"--vary", "bodies[0].density=300:500", "--samples", "6",
                                          "--seed"};
  EXPECT_EQ(sweep("o", words + std::vector<std::string>{"7"}).code, 0);
  EXPECT_EQ(sweep("p", words + std::vector<std::string>{"7"}).code, 0);
  EXPECT_EQ(sweep("q", words + std::vector<std::string>{"8"}).code, 0);
  EXPECT_THAT(column("o", 1), testing::SizeIs(7));
  EXPECT_EQ(column("o", 1), column("p", 1));
  EXPECT_NE(column("o", 1), column("q", 1));
}

TEST_F(ProgramSweep, DoesWhatIsNotDoneAndNothingElse) {
  sweep("o", kGrid);
  const std::vector<std::string> whole = table("o");
  fs::remove(run_file("o", "0001", "outcome.json"));
  fs::resize_file(run_file("o", "0001", "trajectory.csv"), 100);
  fs::resize_file(run_file("o", "0003", "outcome.json"), 10);
  fs::remove(here / "o/sweep.csv");
  std::ofstream(run_file("o", "0000", "messages.txt")) << "kept";
  std::ofstream(run_file("o", "0001", "messages.txt")) << "done anew";
  const Outcome again = sweep("o", kGrid + std::vector<std::string>{"--quiet"});
  EXPECT_EQ(again.code, 0);
  EXPECT_EQ(again.err, "");
  EXPECT_EQ(table("o"), whole);
  EXPECT_EQ(here.read("o/runs/0000/messages.txt"), "kept");
  EXPECT_THAT(here.read("o/runs/0001/messages.txt"), HasSubstr("20 steps"));
  EXPECT_THAT(lines_of(here.read("o/runs/0001/trajectory.csv")), testing::SizeIs(22));
}

TEST_F(ProgramSweep, AChangedSweepNeedsFresh) {
  const std::vector<std::string> words = {"--vary", "bodies[0].density=300,500"};
  sweep("o", words);
  const Outcome other = sweep("o", {"--vary", "bodies[0].density=300,600"});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, StartsWith("o: holds a sweep that differs from this one in --vary; "));
  EXPECT_THAT(sweep("o", words + std::vector<std::string>{"--set", "step=0.02"}).err,
              HasSubstr("in --set; "));
  EXPECT_THAT(sweep("o", words + std::vector<std::string>{"--samples", "2"}).err,
              HasSubstr("in --samples; "));
  here.write("box.yaml", falling_box("0.3"));
  const Outcome changed = sweep("o", words);
  EXPECT_EQ(changed.code, 2);
  EXPECT_THAT(changed.err, StartsWith("o: holds a sweep that differs from this one in scene; "));
  EXPECT_EQ(sweep("o", words + std::vector<std::string>{"--fresh"}).code, 0);
  EXPECT_THAT(column("o", 3), ElementsAre("simulated_seconds", "0.3", "0.3"));
}

TEST_F(ProgramSweep, AChangedMeshIsAChangedSweep) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  here.write("a.obj", corners + faces);
  const std::vector<std::string> words = {
      "--vary", "bodies[0].density=300,500", "--set",
      "bodies[0]={name: a, mesh: {file: a.obj}, density: 1, hydro: {added_mass: none}}"};
  EXPECT_EQ(sweep("o", words).code, 0);
  EXPECT_EQ(sweep("o", words).code, 0);
  here.write("a.obj", corners + "v 2 2 2\n" + faces);
  EXPECT_THAT(sweep("o", words).err,
              StartsWith("o: holds a sweep that differs from this one in a.obj"));
}

TEST_F(ProgramSweep, FreshLeavesAloneWhatIsNoSweeps) {
  here.write("o/runs/mine.txt", "mine");
  const Outcome outcome = sweep("o", kGrid + std::vector<std::string>{"--fresh"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, StartsWith("o/runs: holds what no sweep has written"));
  EXPECT_EQ(here.read("o/runs/mine.txt"), "mine");
}

/// A value that is right in some runs, and a push that makes the state not finite.
const std::vector<std::string> kFaulty = {"--vary", "gravity=9.8,0",
                                          "--vary", "bodies[0].start=given,equilibrium",
                                          "--vary", "bodies[0].forces=[],[{force: [1e+30, 0, 0]}]"};

TEST_F(ProgramSweep, RunsThatFailHaveTheirRowsAndStopNoOther) {
  const Outcome outcome = sweep("o", kFaulty);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err,
              StartsWith("5 runs failed, the first of them 0001: body 'box' at t = 0 s"));
  const std::vector<std::string> rows = lines_of(here.read("o/sweep.csv"));
  ASSERT_THAT(rows, testing::SizeIs(9));
  EXPECT_THAT(rows[1], StartsWith("0000,9.8,given,[],0,0.2,"));
  EXPECT_THAT(rows[2], StartsWith("0001,9.8,given,\"[{force: [1e+30, 0, 0]}]\",3,0,"));
  EXPECT_THAT(rows[2], HasSubstr("body 'box' at t = 0 s"));
  EXPECT_THAT(rows[7], StartsWith("0006,0,equilibrium,[],2,,"));
  EXPECT_THAT(rows[7], testing::EndsWith(
                           ",\"--set bodies[0].start: equilibrium needs gravity, which is 0 in "
                           "this scene\""));
  EXPECT_EQ(sweep("o", kFaulty).code, 3);
}

TEST_F(ProgramSweep, WrongKeysAndValuesAreFoundBeforeAnythingRuns) {
  const auto fault = [&](const std::vector<std::string>& words) {
    const Outcome outcome = sweep("o", words);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_FALSE(fs::exists(here / "o"));
    return outcome.err;
  };
  EXPECT_THAT(
      fault({"--vary", "bodies[0].densty=1,2"}),
      StartsWith("--vary: bodies[0].densty: unknown key; did you mean density?\n1 problem"));
  EXPECT_THAT(fault({"--vary", "bodies[0].density=1,two,-3"}),
              testing::AllOf(HasSubstr("density: found two"), HasSubstr("density: found -3"),
                             HasSubstr("2 problems, nothing was run.")));
  EXPECT_THAT(fault({"--vary", "bodies[crate].density=1,2"}), HasSubstr("no entry named crate"));
  EXPECT_THAT(fault({"--vary", "bodies[0].density=1,2", "--vary", "bodies[0].density=3"}),
              HasSubstr("is varied twice"));
  EXPECT_THAT(fault({"--vary", "bodies[0].density=1,2", "--only", "2"}),
              HasSubstr("--only: found 2, expected a run from 0 to 1"));
  EXPECT_THAT(fault({"--vary", "bodies[0]={name: a, density: 1, mesh: {file: none.obj}}"}),
              HasSubstr("none.obj"));
  EXPECT_THAT(fault({"--vary", "duration=1,2", "--seed", "2"}), HasSubstr("--seed requires"));
  fault({});
}

TEST_F(ProgramSweep, AValueThatNeedsAnotherOneIsRight) {
  const std::string scene = falling_box("0.1");
  const std::string density = "density: 500, ";
  here.write("box.yaml", std::string(scene).erase(scene.find(density), density.size()));
  EXPECT_EQ(sweep("o", {"--vary", "bodies[0].density=300,400", "--vary", "step=0.01,0.02"}).code,
            0);
}

TEST_F(ProgramSweep, CtrlCKeepsWhatIsDone) {
  const pid_t process = start_endless("o");
  ::kill(process, SIGINT);
  const Outcome outcome = here.finish(process);
  EXPECT_EQ(outcome.code, 130);
  EXPECT_EQ(outcome.err, "o: interrupted; 1 of 2 runs are done; repeat the command to resume\n");
  EXPECT_THAT(column("o", 0), ElementsAre("run", "0000"));
  EXPECT_FALSE(fs::exists(run_file("o", "0001", "outcome.json")));
  EXPECT_EQ(sweep("o", {"--vary", "duration=0.2,1e+7", "--gather"}).code, 3);
  EXPECT_THAT(column("o", 0), ElementsAre("run", "0000"));
}

TEST_F(ProgramSweep, AKilledSweepTakesItsRunsWithIt) {
  const pid_t process = start_endless("o");
  EXPECT_EQ(sweep("o", kEndless).code, 2);
  EXPECT_THAT(sweep("o", {"--vary", "duration=0.2,1e+7", "--only", "0"}).err,
              StartsWith("o: another run is writing to this folder"));
  ::kill(process, SIGKILL);
  EXPECT_EQ(here.finish(process).code, -SIGKILL);
  // Its run has let go of its files.
  EXPECT_EQ(here.shell("exec flock -w 60 o/runs/0001/messages.txt true").code, 0);
  EXPECT_TRUE(fs::exists(run_file("o", "0000", "outcome.json")));
  EXPECT_FALSE(fs::exists(run_file("o", "0001", "outcome.json")));
}

TEST_F(ProgramSweep, TwoPartsDoNotDoTheSameRun) {
  const std::vector<std::string> words = {"--vary", "duration=0.2,1e+7", "--only", "1"};
  const pid_t process = here.start(command("o", words));
  EXPECT_TRUE(
      support::wait_until([&] { return fs::exists(run_file("o", "0001", "trajectory.csv")); }));
  const Outcome second =
      here.shell("$PLIMSOLL sweep box.yaml --out o --vary duration=0.2,1e+7 --only 1");
  EXPECT_EQ(second.code, 2);
  EXPECT_THAT(second.err, HasSubstr("o/runs/0001: another sweep is doing this run"));
  ::kill(process, SIGTERM);
  EXPECT_EQ(here.finish(process).code, 130);
}

TEST_F(ProgramSweep, ARunThatCrashesIsARowAndTriedAnew) {
  const pid_t process = start_endless("o");
  const std::string children =
      "/proc/" + std::to_string(process) + "/task/" + std::to_string(process) + "/children";
  pid_t run = 0;
  std::ifstream(children) >> run;
  if (run == 0) GTEST_SKIP() << "the system does not tell the children of a process";
  ::kill(run, SIGKILL);
  EXPECT_EQ(here.finish(process).code, 3);
  EXPECT_THAT(column("o", 2), ElementsAre("exit_code", "0", "137"));
  EXPECT_THAT(here.read("o/sweep.csv"), HasSubstr(",the run was ended by signal 9\n"));
  const pid_t again = here.start(command("o", kEndless));
  EXPECT_TRUE(support::wait_until([&] {
    return fs::exists(run_file("o", "0001", "trajectory.csv")) &&
           !fs::exists(run_file("o", "0001", "outcome.json"));
  }));
  ::kill(again, SIGTERM);
  EXPECT_EQ(here.finish(again).code, 130);
}

TEST_F(ProgramSweep, PartsAndGatherMakeTheSameTable) {
  sweep("whole", kGrid);
  for (const char* run : {"3", "0", "2"})
    EXPECT_EQ(sweep("parts", kGrid + std::vector<std::string>{"--only", run}).code, 0);
  const Outcome early = sweep("parts", kGrid + std::vector<std::string>{"--gather"});
  EXPECT_EQ(early.code, 3);
  EXPECT_THAT(early.err, StartsWith("parts: 3 of 4 runs are done; the table sweep.csv has"));
  EXPECT_EQ(sweep("parts", kGrid + std::vector<std::string>{"--only", "1"}).code, 0);
  EXPECT_EQ(sweep("parts", kGrid + std::vector<std::string>{"--gather"}).code, 0);
  EXPECT_EQ(table("parts"), table("whole"));
  EXPECT_EQ(sweep("none", kGrid + std::vector<std::string>{"--gather"}).err,
            "none: holds no sweep, expected the folder of one\n1 problem, nothing was run.\n");
}

/// A stand-in for Slurm's sbatch that does its jobs at once.
const char* const kSbatch = R"(#!/bin/bash
echo "$*" >> calls.txt
for word; do
  [[ $word == --wrap=* ]] && exec sh -c "${word#--wrap=}"
done
script=${!#}
array=$(sed -n 's/^#SBATCH --array=0-\([0-9]*\).*/\1/p' "$script")
for ((i = 0; i <= array; ++i)); do
  SLURM_ARRAY_TASK_ID=$i bash "$script" >&2
done
echo 17
)";

TEST_F(ProgramSweep, TheSlurmScriptDoesAllRunsAndTheTable) {
  sweep("whole", kGrid);
  here.write("bin/sbatch", kSbatch);
  fs::permissions(here / "bin/sbatch", fs::perms::owner_all);
  const Outcome made = sweep("it's here", kGrid + std::vector<std::string>{"--slurm", "-j", "3"});
  EXPECT_EQ(made.code, 0);
  EXPECT_EQ(made.err, "4 runs; submit them with: bash 'it'\\''s here/sweep.sbatch'\n");
  EXPECT_FALSE(fs::exists(here / "it's here/runs"));
  EXPECT_THAT(here.read("it's here/sweep.sbatch"), HasSubstr("#SBATCH --array=0-3%3\n"));
  const Outcome checked = here.shell("bash -n 'it'\\''s here/sweep.sbatch'");
  EXPECT_EQ(checked.code, 0) << checked.err;
  const Outcome ran = here.shell("PATH=$PWD/bin:$PATH bash 'it'\\''s here/sweep.sbatch'");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(table("it's here"), table("whole"));
  EXPECT_THAT(here.read("calls.txt"), HasSubstr("--dependency=afterany:17 "));
}

TEST_F(ProgramSweep, RanksShareTheRunsAndTheFirstWritesTheTable) {
  sweep("whole", kGrid);
  // As Open MPI starts two ranks.
  const Outcome outcome = here.shell(
      "two() { env OMPI_COMM_WORLD_SIZE=2 OMPI_COMM_WORLD_RANK=$1 $PLIMSOLL sweep box.yaml --out o "
      "--vary bodies[0].density=300:500:200 --vary 'bodies[box].box.divisions=1,2'; }; "
      "two 1 & two 0 || exit; wait $!");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "o: 4 of 4 runs are done; the table is sweep.csv\n");
  EXPECT_EQ(table("o"), table("whole"));
}

TEST_F(ProgramSweep, RanksCannotStartAnewTogether) {
  const Outcome outcome = here.run(command("o", kGrid + std::vector<std::string>{"--fresh"}),
                                   {"PMI_SIZE=2", "PMI_RANK=0"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, StartsWith("--fresh: cannot be combined with several ranks"));
}

#ifdef PLIMSOLL_MPIRUN
TEST_F(ProgramSweep, MpirunSpreadsItOverItsRanks) {
  sweep("whole", kGrid);
  const Outcome outcome =
      here.shell(PLIMSOLL_MPIRUN
                 " --allow-run-as-root --oversubscribe -np 2 $PLIMSOLL sweep box.yaml --out o "
                 "--vary bodies[0].density=300:500:200 --vary 'bodies[box].box.divisions=1,2'");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(table("o"), table("whole"));
}
#endif

TEST_F(ProgramSweep, RunsOfOneMeshSolveForItsAddedMassOnce) {
  const std::vector<std::string> words = {"--vary", "bodies[0].density=300:600:100",
                                          "--set",  "bodies[0].hydro.added_mass={tolerance: 1e+3}",
                                          "-j",     "4"};
  EXPECT_EQ(sweep("o", words).code, 0);
  int solved = 0;
  for (const char* run : {"0000", "0001", "0002", "0003"}) {
    const json summary = json::parse(here.read(run_file("o", run, "summary.json")));
    if (summary["bodies"]["box"]["added_mass"]["from_store"] == false) ++solved;
  }
  EXPECT_EQ(solved, 1);
}

}  // namespace
