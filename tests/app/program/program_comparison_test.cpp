#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/program/page.h"
#include "tests/app/program/program.h"

/// The data that `plimsoll compare --html` puts into its page, and what it says when it cannot.

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::Outcome;
using support::packed_numbers;
using support::trajectory;
using support::Workplace;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class ProgramComparison : public testing::Test {
 protected:
  ProgramComparison() { support::lay_out_page(here, "comparison.html"); }

  Outcome compare(const std::string& arguments) const {
    return here.shell("bin/plimsoll compare " + arguments);
  }

  /// The data in the page of a comparison, which ends with a code.
  json data(const std::string& arguments, int code) const {
    const Outcome outcome = compare(arguments + " --html c.html");
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_THAT(outcome.err, StartsWith("c.html: 0.0 MB"));
    return support::data_in_page(here.read("c.html"));
  }

  Workplace here;
};

TEST_F(ProgramComparison, ReplaysBothRuns) {
  here.write("box.yaml", support::falling_box("0.2"));
  ASSERT_EQ(here.run({"run", "box.yaml", "--out", "a", "--quiet"}).code, 0);
  ASSERT_EQ(here.run({"run", "box.yaml", "--out", "b", "--quiet", "--set",
                      "bodies[box].position=[1, 0, 2.5]"})
                .code,
            0);
  const json replay = data("a b", 1)["replay"];
  ASSERT_FALSE(replay.contains("note")) << replay["note"];
  EXPECT_EQ(replay["a"]["water"]["kind"], "flat");
  EXPECT_FALSE(replay["b"].contains("water"));
  EXPECT_EQ(replay["a"]["origin"], replay["b"]["origin"]);  // so they are drawn in one frame
  const std::vector<float> a = packed_numbers<float>(replay["a"]["poses"]["bodies"][0]);
  const std::vector<float> b = packed_numbers<float>(replay["b"]["poses"]["bodies"][0]);
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a[0], 0);
  EXPECT_EQ(b[0], 1);
  EXPECT_EQ(replay["b"]["bodies"][0]["name"], "box");
}

TEST_F(ProgramComparison, SaysWhyThereIsNoReplay) {
  const std::string mesh =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  here.write("t.obj", mesh);
  here.write("t.yaml",
             "plimsoll: 1\nduration: 0.2\nbodies: [{name: t, mesh: {file: t.obj}, mass: 1}]\n");
  ASSERT_EQ(here.run({"run", "t.yaml", "--out", "a", "--quiet"}).code, 0);
  EXPECT_EQ(data("a a/trajectory.csv", 0)["replay"]["note"],
            "a/trajectory.csv is a log and not the folder of a run");
  EXPECT_FALSE(data("a a", 0)["replay"].contains("note"));
  fs::remove(here / "t.obj");
  const json page = data("a a", 0);
  EXPECT_THAT(page["replay"]["note"].get<std::string>(), HasSubstr("t.obj"));
  EXPECT_EQ(page["bodies"].size(), 1u);
}

TEST_F(ProgramComparison, HasTheVerdictAndTheTable) {
  here.write("a.csv", trajectory({"0,p,0", "1,p,0", "2,p,0", "0,q,0", "2,q,0"}));
  here.write("b.csv", trajectory({"0,p,0", "1,p,0.25", "2,p,0.5", "0,q,0", "2,q,0"}));
  const json page = data("a.csv b.csv --tol position=0.1", 1);
  EXPECT_EQ(page["a"], "a.csv");
  EXPECT_EQ(page["b"], "b.csv");
  EXPECT_EQ(page["same"], false);
  ASSERT_EQ(page["bodies"].size(), 2u);
  EXPECT_EQ(page["bodies"][0]["name"], "p");
  EXPECT_EQ(page["bodies"][0]["same"], false);
  EXPECT_EQ(page["bodies"][1]["same"], true);
  const json& position = page["bodies"][0]["differences"][0];
  EXPECT_EQ(position["largest"], 0.5);
  EXPECT_EQ(position["at"], 2);
  EXPECT_EQ(position["tolerance"], 0.1);
  EXPECT_EQ(position["first_beyond"], 1);
  EXPECT_EQ(position["verdict"], "exceeds it from 1 s");
  const json& turned = page["bodies"][0]["differences"][1];
  EXPECT_TRUE(turned["tolerance"].is_null());
  EXPECT_TRUE(turned["first_beyond"].is_null());
  EXPECT_EQ(data("a.csv a.csv", 0)["same"], true);
}

TEST_F(ProgramComparison, HasEachLogAtItsOwnTimesAndTheDifferences) {
  here.write("a.csv", trajectory({"0,p,1", "1,p,2", "2,p,4"}));
  here.write("b.csv", trajectory({"0,p,1", "2,p,4.5", "3,p,7"}));
  const json body = data("a.csv b.csv", 1)["bodies"][0];
  EXPECT_EQ(body["note"], "2 times compared, 0 rows only in a.csv, 1 only in b.csv");
  EXPECT_THAT(packed_numbers<double>(body["a"]["times"]), ElementsAre(0, 1, 2));
  EXPECT_THAT(packed_numbers<double>(body["b"]["times"]), ElementsAre(0, 2, 3));
  EXPECT_THAT(packed_numbers<double>(body["over"]["times"]), ElementsAre(0, 2));
  EXPECT_EQ(body["b"]["columns"][0]["base"], 1);
  EXPECT_THAT(packed_numbers<float>(body["b"]["columns"][0]["data"]), ElementsAre(0, 3.5, 6));
  EXPECT_THAT(packed_numbers<float>(body["over"]["columns"][0]["data"]), ElementsAre(0, 0.5));
  EXPECT_EQ(body["over"]["columns"][1], 0);  // never turned
}

TEST_F(ProgramComparison, DrawsAnglesBesideEachOtherAcrossAHalfTurn) {
  // A quarter of a degree to either side of a yaw of 180 degrees.
  const std::string yaw = "0,0,0.0021816616,0,0,1,0,0,0,0,0,0\n";
  const std::string other = "0,0,-0.0021816616,0,0,1,0,0,0,0,0,0\n";
  here.write("a.csv", support::kTrajectoryHeader + "0,p,0," + yaw);
  here.write("b.csv", support::kTrajectoryHeader + "0,p,0," + other);
  const json body = data("a.csv b.csv", 1)["bodies"][0];
  constexpr double kRounding = 1e-5;  // [deg], of the quaternion's digits
  EXPECT_NEAR(body["a"]["columns"][5].get<double>(), 179.75, kRounding);
  EXPECT_NEAR(body["b"]["columns"][5].get<double>(), 180.25, kRounding);
}

TEST_F(ProgramComparison, HasBodiesThatAreOnlyInOneLog) {
  here.write("a.csv", trajectory({"0,p,0", "0,q</script>,0"}));
  here.write("b.csv", trajectory({"0,p,0", "0,r,0"}));
  const json bodies = data("a.csv b.csv", 1)["bodies"];
  ASSERT_EQ(bodies.size(), 3u);
  EXPECT_EQ(bodies[1]["name"], "q</script>");
  EXPECT_EQ(bodies[1]["note"], "only in a.csv");
  EXPECT_FALSE(bodies[1].contains("b") || bodies[1].contains("differences"));
  EXPECT_FALSE(bodies[2].contains("a"));
}

TEST_F(ProgramComparison, PrintsTheSameWithAndWithoutAPage) {
  here.write("a.csv", trajectory({"0,p,0"}));
  here.write("b.csv", trajectory({"0,p,1"}));
  EXPECT_EQ(compare("a.csv b.csv --html c.html").out, compare("a.csv b.csv").out);
  EXPECT_EQ(compare("a.csv b.csv --json --html c.html").out, compare("a.csv b.csv --json").out);
}

TEST_F(ProgramComparison, SaysHowToGetAPageThatWasNotBuiltBeforeItPrints) {
  here.write("a.csv", trajectory({"0,p,0"}));
  fs::remove(here / "share/plimsoll/report/comparison.html");
  const Outcome outcome = compare("a.csv a.csv --html c.html");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("for which npm is needed; run tools/report, or install npm "
                                     "and build the target report_page"));
  EXPECT_FALSE(fs::exists(here / "c.html"));
  EXPECT_EQ(compare("a.csv a.csv").code, 0);
}

TEST_F(ProgramComparison, WritesNoPageOfLogsThatAreBroken) {
  here.write("a.csv", trajectory({"0,p,0"}));
  EXPECT_EQ(compare("a.csv none.csv --html c.html").code, 2);
  EXPECT_FALSE(fs::exists(here / "c.html"));
}

/// A summary of a run of a scene of one body, with overrides.
std::string summary(const std::string& version, const std::string& digest,
                    const std::string& overrides) {
  return R"({"version": ")" + version + R"(", "bodies": {"p": {"triangles": 12, "mesh_digest": ")" +
         digest + R"("}}, "source": {"file": "/p.yaml", "overrides": [)" + overrides +
         R"(], "text": "duration: 2.0\nbodies: [{name: p, mass: 3}]\n"}})";
}

class ProgramRuns : public ProgramComparison {
 protected:
  /// Writes a run that ends at x.
  void write_run(const std::string& folder, const std::string& x) const {
    fs::create_directories(here / folder);
    here.write(folder + "/trajectory.csv", trajectory({"0,p,0", "1,p," + x}));
  }
};

TEST_F(ProgramRuns, SaysFirstWhatMadeThemDiffer) {
  write_run("a", "0");
  write_run("b", "0");
  here.write("a/summary.json", summary("1.0", "aa", ""));
  here.write("b/summary.json", summary("1.1", "bb", R"("bodies[p].mass=4", "log.every=0.5")"));
  const Outcome outcome = compare("a b");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("A: a\nB: b\n"
                                      "  program     A    B\n"
                                      "  plimsoll  1.0  1.1\n"
                                      "  scene key       A    B\n"
                                      "  bodies[p].mass  3    4\n"
                                      "  log.every       -  0.5\n"));
  EXPECT_THAT(outcome.out, HasSubstr("12 triangles, digest aa  12 triangles, digest bb"));
  const json told = json::parse(compare("a b --json").out);
  EXPECT_EQ(told["differs"]["keys"], json::parse(R"({"bodies[p].mass": ["3", "4"],
                                                     "log.every": [null, "0.5"]})"));
  EXPECT_EQ(data("a b", 0)["differs"]["programs"]["plimsoll"][1], "1.1");
  here.write("b/summary.json", summary("1.0", "aa", R"("duration=2")"));
  EXPECT_THAT(compare("a b").out, HasSubstr("program, scene and meshes are the same\n"));
}

TEST_F(ProgramRuns, ComparesTheTablesOfFolders) {
  const std::string header = "time,set_point,value\n";
  for (const std::string folder : {"a", "b"}) {
    write_run(folder, "0");
    here.write(folder + "/controls.csv",
               header + "0,helm,1\n1,helm," + (folder == "a" ? "2\n" : "2.5\n"));
  }
  const Outcome outcome = compare("a b --junit j.xml");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("controls: 1 quantity of 1 name, 1 judged, 1 beyond"));
  EXPECT_THAT(outcome.out, HasSubstr("controls.value"));
  EXPECT_THAT(here.read("j.xml"), HasSubstr("<property name=\"A\" value=\"a\"/>"));
  EXPECT_THAT(here.read("j.xml"), HasSubstr("classname=\"helm\" name=\"controls.value\">"));
  EXPECT_EQ(compare("a b --tol controls.value=0.5").code, 0);
  EXPECT_EQ(compare("a b --tol position=0").code, 0);  // others are not judged
  EXPECT_EQ(data("a b --tol position=0", 0)["verdict"],
            "the same within tolerance by position; not judged: orientation_deg, linear_velocity, "
            "angular_velocity, controls");
  EXPECT_EQ(data("a b", 1)["verdict"], "different");
  EXPECT_EQ(compare("a/trajectory.csv b/trajectory.csv").code, 0);
  const json table = data("a b", 1)["tables"][0];
  EXPECT_EQ(table["beyond"][0]["differences"][0]["largest"], 0.5);
  here.write("b/controls.csv", header + "0,helm,one\n");
  EXPECT_THAT(compare("a b").err, StartsWith("b/controls.csv:2:1: found \"one\", expected a "));
}

TEST_F(ProgramRuns, ComparesFoldersOfRunsByTheirNames) {
  for (const std::string run : {"runs/0", "runs/1"})
    for (const std::string folder : {"a/", "b/"}) write_run(folder + run, "0");
  EXPECT_EQ(compare("a b").code, 0);
  write_run("b/runs/1", "0.25");
  write_run("b/runs/2", "0");
  const Outcome outcome = compare("a b --junit j.xml");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out,
            "A: a\nB: b\n\n"
            "runs/0  the same within tolerance\n"
            "runs/1  different: p position by 0.25 m at 1 s, tolerance 1e-09\n"
            "runs/2  only in b\n"
            "2 of 3 runs different\n");
  EXPECT_THAT(here.read("j.xml"), HasSubstr("<testsuite name=\"a/runs/1 and b/runs/1\""));
  const json told = json::parse(compare("a b --json").out);
  EXPECT_EQ(told["runs"]["runs/1"]["bodies"]["p"]["position"]["largest"], 0.25);
  EXPECT_EQ(told["runs"]["runs/2"]["fault"], "only in b");
  EXPECT_EQ(compare("a b --html c.html").code, 2);
  EXPECT_THAT(compare("a b/runs/0").err, StartsWith("a: holds runs and is none, while b/runs/0 "));
}

TEST_F(ProgramRuns, LearnsTolerancesThatTheRunsMeet) {
  for (const auto& [folder, x] : {std::pair("a", "0"), {"b", "0.01"}, {"c", "0.02"}})
    write_run(folder, x);
  const Outcome outcome = compare("a b c --learn t.yaml --margin 2");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "t.yaml: 4 tolerances from 3 runs\n");
  EXPECT_THAT(here.read("t.yaml"), HasSubstr("position:\n  peak: 0.04\n  rms: 0.029\n"));
  EXPECT_EQ(compare("a c --tolerances t.yaml").code, 0);
  write_run("c", "0.05");
  EXPECT_EQ(compare("a c --tolerances t.yaml").code, 1);
  EXPECT_EQ(compare("a b c").code, 2);
  EXPECT_EQ(compare("a b --margin 2").code, 2);
}

TEST_F(ProgramRuns, LearnsTolerancesFromFoldersOfRuns) {
  for (const auto& [folder, x] : {std::pair("a", "0"), {"b", "0.01"}, {"c", "0.02"}})
    for (const std::string run : {"/runs/0", "/runs/1"}) write_run(folder + run, x);
  write_run("b/runs/1", "0.05");
  const Outcome outcome = compare("a b c --learn t.yaml --margin 2");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "t.yaml: 4 tolerances from 3 folders of 2 runs each\n");
  EXPECT_THAT(here.read("t.yaml"), HasSubstr("position:\n  peak: 0.1\n"));
  EXPECT_EQ(compare("a b --tolerances t.yaml").code, 0);
  write_run("c/runs/2", "0");
  EXPECT_THAT(compare("a b c --learn t.yaml").err,
              StartsWith("c: the run runs/2 is only in c, so no tolerance can be learned\n"));
}

}  // namespace
