#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/program/page.h"
#include "tests/app/program/program.h"
#include "tests/support/files.h"

/// Several scenes in one call of `run`, and several runs on one page of `report`.

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::falling_box;
using support::Outcome;
using support::packed_numbers;
using support::trajectory;
using support::Workplace;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class ProgramSeveralScenes : public testing::Test {
 protected:
  Workplace here;
};

TEST_F(ProgramSeveralScenes, AreRunAsEachAlone) {
  here.write("a.yaml", falling_box("0.2"));
  here.write("b.yaml", falling_box("0.3"));
  const Outcome outcome = here.run({"run", "a.yaml", "b.yaml", "--set", "bodies[0].density=300"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("\nout/a: 20 steps"), HasSubstr("\nout/b: 30 steps")));
  here.run({"run", "b.yaml", "--set", "bodies[0].density=300", "--out", "alone"});
  EXPECT_EQ(here.read("out/b/trajectory.csv"), here.read("alone/trajectory.csv"));
  EXPECT_EQ(here.run({"run", "a.yaml", "b.yaml", "--out", "o", "--quiet"}).code, 0);
  EXPECT_THAT(support::files_in(here / "o"), ElementsAre("a", "b"));
}

TEST_F(ProgramSeveralScenes, TellTheFaultsOfAllBeforeTheFirstIsRun) {
  here.write("good.yaml", falling_box("0.2"));
  here.write("wrong.yaml", "plimsoll: 1\nduration: -1\n");
  here.write("open.yaml",
             "plimsoll: 1\nduration: 1\nbodies:\n  - {name: t, mesh: {file: t.obj}, mass: 1}\n");
  const Outcome outcome = here.run({"run", "good.yaml", "wrong.yaml", "open.yaml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err,
              AllOf(StartsWith("wrong.yaml:2:11: duration: found -1"), HasSubstr("\nopen.yaml:4:"),
                    HasSubstr("t.obj"), testing::EndsWith("\n2 problems, nothing was run.\n")));
  EXPECT_FALSE(fs::exists(here / "out"));
}

TEST_F(ProgramSeveralScenes, NeedFoldersOfTheirOwn) {
  here.write("a/x.yaml", falling_box("0.2"));
  here.write("b/x.yaml", falling_box("0.2"));
  EXPECT_THAT(here.run({"run", "a/x.yaml", "b/x.yaml"}).err,
              StartsWith("b/x.yaml: its results would replace those of a/x.yaml in out/x; expected "
                         "scenes of different names\n"));
  EXPECT_THAT(here.run({"run", "a/x.yaml", "b/x.yaml", "--video", "x.mp4"}).err,
              StartsWith("--video: found 2 scenes, expected one for a video\n"));
  EXPECT_FALSE(fs::exists(here / "out"));
}

TEST_F(ProgramSeveralScenes, EndWithTheWorstCodeAndAllAreRun) {
  const std::string head = "plimsoll: 1\nduration: 0.2\nstep: 0.01\nbodies:\n";
  const std::string box = "  - {name: box, box: {size: [1, 1, 1]}, density: 500";
  here.write("bursts.yaml", head + box + ", forces: [{force: [1e+30, 0, 0], start: 0.1}]}\n");
  here.write("falls.yaml", head + box + "}\n");
  const Outcome outcome = here.run({"run", "bursts.yaml", "falls.yaml", "--quiet"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("error: body 'box' at t = 0.1 s: "));
  EXPECT_EQ(json::parse(here.read("out/falls/summary.json"))["ended"], "completed");
}

class ProgramSeveralRuns : public testing::Test {
 protected:
  ProgramSeveralRuns() { support::lay_out_page(here, "runs.html"); }

  Outcome report(const std::string& arguments) const {
    return here.shell("bin/plimsoll report " + arguments);
  }

  /// The data in the page of several runs.
  json data(const std::string& arguments) const {
    const Outcome outcome = report(arguments + " --out r.html");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, StartsWith("r.html: 0.0 MB, "));
    return support::data_in_page(here.read("r.html"));
  }

  Workplace here;
};

TEST_F(ProgramSeveralRuns, HaveEachBodyAtTheTimesOfEachLog) {
  here.write("a.csv", trajectory({"0,p,1", "1,p,2", "0,q,5", "1,q,5"}));
  here.write("b.csv", trajectory({"0,p,1", "2,p,4.5", "3,p,7"}));
  const json page = data("a.csv b.csv a.csv");
  EXPECT_EQ(page["runs"], json({"a.csv", "b.csv", "a.csv"}));
  ASSERT_EQ(page["bodies"].size(), 2u);
  const json& p = page["bodies"][0]["runs"];
  EXPECT_THAT(packed_numbers<double>(p[1]["motion"]["times"]), ElementsAre(0, 2, 3));
  EXPECT_EQ(p[1]["motion"]["columns"][0]["base"], 1);
  EXPECT_THAT(packed_numbers<float>(p[1]["motion"]["columns"][0]["data"]), ElementsAre(0, 3.5, 6));
  EXPECT_TRUE(p[1]["loads"].is_null());
  EXPECT_EQ(p[0], p[2]);
  const json& q = page["bodies"][1]["runs"];
  EXPECT_TRUE(q[1].is_null());
  EXPECT_EQ(q[0]["motion"]["columns"][0], 5);
}

TEST_F(ProgramSeveralRuns, HaveTheLoadsOfThoseThatLogThem) {
  here.write("box.yaml", falling_box("0.1"));
  ASSERT_EQ(here.run({"run", "box.yaml", "--out", "a", "--quiet"}).code, 0);
  ASSERT_EQ(here.run({"run", "box.yaml", "--out", "b", "--quiet", "--set", "log.forces=true"}).code,
            0);
  const json page = data("a b");
  const json& runs = page["bodies"][0]["runs"];
  EXPECT_TRUE(runs[0]["loads"].is_null());
  const auto weight = std::ranges::find(page["loads"], "weight_fz") - page["loads"].begin();
  EXPECT_LT(runs[1]["loads"]["columns"][static_cast<std::size_t>(weight)].get<double>(), 0);
  for (const json& name : page["loads"])
    EXPECT_THAT(name.get<std::string>(), testing::Not(StartsWith("work_")));
}

TEST_F(ProgramSeveralRuns, TellTheFaultsOfAll) {
  here.write("a.csv", trajectory({"0,p,one"}));
  const Outcome outcome = report("a.csv none.csv");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err,
              AllOf(StartsWith("a.csv:2:"), HasSubstr("\nnone.csv"), HasSubstr("\n2 problems.\n")));
  EXPECT_THAT(report("a.csv a.csv --scene x.yaml").err,
              StartsWith("--scene: is for the report of"));
}

}  // namespace
