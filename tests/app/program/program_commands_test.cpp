#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/program/program.h"
#include "tests/support/tolerance.h"

/// The commands beside `run`: check, probe, compare, render.

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::falling_box;
using support::lines_of;
using support::Outcome;
using support::tolerance;
using support::Workplace;
using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class ProgramNew : public testing::Test {
 protected:
  Workplace here;
};

/// The scene with what is commented out in it switched on, but for what needs a file of the user's.
std::string with_all_keys(const std::string& scene) {
  std::string all;
  for (const std::string& line : lines_of(scene)) {
    const std::size_t mark = line.find_first_not_of(' ');
    const bool key = mark != std::string::npos && line.compare(mark, 2, "# ") == 0 &&
                     line.find(": ", mark) < line.find(". ", mark) &&
                     line.find("mesh:") == std::string::npos;
    const bool list = line == "# joints:" || line.starts_with("#   - ");
    all += key || list ? line.substr(0, mark) + line.substr(mark + 2) : line;
    all += '\n';
  }
  return all;
}

TEST_F(ProgramNew, WritesASceneThatRuns) {
  const Outcome made = here.run({"new", "my \"first\" buoy"});
  EXPECT_EQ(made.code, 0);
  EXPECT_THAT(made.out, StartsWith("my \"first\" buoy.yaml: "));
  const Outcome ran =
      here.run({"run", "my \"first\" buoy.yaml", "--set", "duration=0.1", "--no-render", "--set",
                "hydro={added_mass: none}", "--out", "out"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(fs::exists(here / "out/trajectory.csv"));
}

TEST_F(ProgramNew, WritesASceneWhoseBodiesMakeWaves) {
  here.run({"new", "a.yaml"});
  const Outcome outcome = here.run({"check", "a.yaml"});
  EXPECT_THAT(outcome.out, HasSubstr("buoy: radiation: "));
  EXPECT_THAT(outcome.out, HasSubstr("crate: radiation: "));
  EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("no radiation")));
}

TEST_F(ProgramNew, ShowsKeysThatAreRight) {
  here.run({"new", "a.yaml"});
  const std::string all = with_all_keys(here.read("a.yaml"));
  EXPECT_THAT(all, HasSubstr("\nground: {"));
  EXPECT_THAT(all, HasSubstr("\njoints:\n  - {type: ball"));
  EXPECT_THAT(all, HasSubstr("\n    lock: ["));
  here.write("all.yaml", all);
  const Outcome outcome = here.run({"check", "all.yaml"});
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("2 bodies"));
  EXPECT_THAT(outcome.out, HasSubstr("1 joint"));
}

TEST_F(ProgramNew, LeavesAFileThatIsThereAlone) {
  here.write("a.yaml", "mine\n");
  const Outcome outcome = here.run({"new", "a"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, StartsWith("a.yaml: is there already, and is left as it is\n"));
  EXPECT_EQ(here.read("a.yaml"), "mine\n");
}

class ProgramCheck : public testing::Test {
 protected:
  Workplace here;
};

TEST_F(ProgramCheck, SaysWhatARightSceneHolds) {
  here.write("box.yaml", falling_box("1"));
  const Outcome outcome = here.run({"check", "box.yaml"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(lines_of(outcome.out),
              ElementsAre("box.yaml: ok: 1 body, 48 triangles, 0 joints", StartsWith("  body"),
                          AllOf(StartsWith("  box"), HasSubstr("1 x 1 x 1"), HasSubstr("500")),
                          AllOf(StartsWith("  cost without added mass: "),
                                HasSubstr(" ms a step, "), HasSubstr(" x real time"))));
  EXPECT_FALSE(fs::exists(here / "out"));
}

TEST_F(ProgramCheck, TellsAllFaultsOfAllScenes) {
  here.write("a.yaml", "plimsoll: 1\nduration: -1\nstep: 0\n");
  here.write("b.yaml", falling_box("1"));
  here.write("c.yaml", falling_box("1", "log: {evry: 1}\n"));
  const Outcome outcome = here.run({"check", "a.yaml", "b.yaml", "c.yaml", "none.yaml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(lines_of(outcome.err),
              ElementsAre(StartsWith("a.yaml:2:11: duration: "), StartsWith("a.yaml:3:7: step: "),
                          "c.yaml:8:7: log.evry: unknown key; did you mean every?",
                          "none.yaml: there is no such file", "4 problems."));
  EXPECT_THAT(outcome.out, StartsWith("b.yaml: ok"));
}

TEST_F(ProgramCheck, LooksIntoTheMeshes) {
  here.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  here.write("s.yaml",
             "plimsoll: 1\nduration: 1\nbodies:\n"
             "  - {name: a, mesh: {file: open.obj}, density: 1}\n");
  const Outcome outcome = here.run({"check", "s.yaml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, StartsWith("s.yaml:4:21: bodies[0].mesh: 3 edges are open"));
}

class ProgramProbe : public testing::Test {
 protected:
  json probe(const std::vector<std::string>& overrides) const {
    std::vector<std::string> arguments = {"probe", "box.yaml"};
    for (const std::string& override : overrides) {
      arguments.push_back("--set");
      arguments.push_back(override);
    }
    const Outcome outcome = here.run(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out)["bodies"]["box"];
  }
  Workplace here;
};

TEST_F(ProgramProbe, HasTheKeysThatScriptsRelyOn) {
  here.write("box.yaml", falling_box("1"));
  std::vector<std::string> keys;
  const auto all = nlohmann::ordered_json::parse(here.run({"probe", "box.yaml"}).out);
  for (const auto& [key, value] : all["bodies"]["box"].items()) keys.push_back(key);
  EXPECT_THAT(keys,
              ElementsAre("com", "mass", "inertia", "displaced_volume", "wetted_area", "buoyancy",
                          "pressure_drag", "viscous_drag", "lift", "wave_inertia", "diffraction",
                          "hull_lift", "wind", "interior", "pockets", "added_mass", "resistance"));
}

// A cube of 1 m sunk by half and moving down at 2 m/s: closed forms, to the rounding of sums over
// its triangles.
TEST_F(ProgramProbe, GivesTheLoadsOfTheContract) {
  here.write("box.yaml", falling_box("1"));
  const json box = probe({"bodies[0].position=[3, 4, 0]", "bodies[0].linear_velocity=[0, 0, -2]",
                          "hydro.pressure_drag=1", "hydro.viscous_drag=0.1", "hydro.lift=0"});
  EXPECT_NEAR(box["mass"], 500, tolerance(1e-10));
  EXPECT_NEAR(box["com"][0], 3, tolerance(1e-14));
  EXPECT_NEAR(box["inertia"][2][2], 500.0 / 6, tolerance(1e-10));
  EXPECT_NEAR(box["displaced_volume"], 0.5, tolerance(1e-13));
  EXPECT_NEAR(box["wetted_area"], 3, tolerance(1e-13));
  EXPECT_NEAR(box["buoyancy"]["force"][2], 500 * 9.80665, tolerance(1e-9));
  EXPECT_NEAR(box["pressure_drag"]["force"][2], 0.5 * 1000 * 4, tolerance(1e-9));
  // Friction on the four sides, 2 m^2 under water; quadrature is good to 1e-5.
  EXPECT_NEAR(box["viscous_drag"]["force"][2], 0.5 * 1000 * 0.1 * 4 * 2, tolerance(4e-3));
  EXPECT_NEAR(box["buoyancy"]["torque"][0], 0, tolerance(1e-9));
}

TEST_F(ProgramProbe, MeasuresABodyThatTheWaterLeavesAlone) {
  here.write("box.yaml", falling_box("1"));
  const json box = probe({"bodies[0].position=[0, 0, 0]",
                          "hydro={buoyancy: false, pressure_drag: 0, lift: 0, viscous_drag: 0}"});
  EXPECT_NEAR(box["displaced_volume"], 0.5, tolerance(1e-13));
  EXPECT_EQ(box["buoyancy"]["force"][2], 0);
}

class ProgramCompare : public testing::Test {
 protected:
  /// Compares two logs of rows `time,body,x`.
  Outcome compare(const std::vector<std::string>& a, const std::vector<std::string>& b,
                  const std::vector<std::string>& options = {}) const {
    const auto text = [](const std::vector<std::string>& rows) {
      std::string table = "time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n";
      for (const std::string& row : rows) table += row + ",0,0,1,0,0,0,0,0,0,0,0,0\n";
      return table;
    };
    std::vector<std::string> arguments = {"compare", here.write("a.csv", text(a)),
                                          here.write("b.csv", text(b))};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return here.run(arguments);
  }
  Workplace here;
};

TEST_F(ProgramCompare, OfTheSameIsCodeZero) {
  const Outcome outcome = compare({"0,p,1", "1,p,2"}, {"0,p,1", "1,p,2"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, EndsWith("the same within tolerance\n"));
}

TEST_F(ProgramCompare, SaysWhatWasJudged) {
  const auto verdict = [&](const std::string& tolerance) {
    const Outcome outcome = compare({"0,p,1"}, {"0,p,1"}, {"--tol", tolerance});
    EXPECT_EQ(outcome.code, 0);
    return lines_of(outcome.out).back();
  };
  EXPECT_EQ(verdict("position=1"),
            "the same within tolerance by position; not judged: orientation_deg, linear_velocity, "
            "angular_velocity");
  EXPECT_EQ(verdict("position=1,orientation_deg=1,linear_velocity=1,angular_velocity.rms=1"),
            "the same within tolerance");
  EXPECT_EQ(verdict("forces.buoyancy=1"),
            "nothing was judged: none of the tolerances is of what both runs have");
  const Outcome outcome = compare({"0,p,1"}, {"0,p,1"}, {"--tol", "position=1", "--json"});
  const json told = json::parse(outcome.out);
  EXPECT_EQ(told["judged"], json({"position"}));
  EXPECT_EQ(told["not_judged"], json({"orientation_deg", "linear_velocity", "angular_velocity"}));
}

TEST_F(ProgramCompare, BeyondToleranceIsCodeOneWithTheLargestAndTheFirst) {
  const std::vector<std::string> a = {"0,p,0", "1,p,0", "2,p,0", "3,p,0"};
  const std::vector<std::string> b = {"0,p,0", "1,p,0.01", "2,p,0.5", "3,p,0.3"};
  const Outcome outcome = compare(a, b, {"--tol", "position=0.1"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, StartsWith("A: a.csv\nB: b.csv\n\nbody "));
  EXPECT_THAT(
      lines_of(outcome.out)[4],
      testing::MatchesRegex("p +position +0\\.5 +0\\.2916 m +2\\.000 +0\\.1  exceeds it from 2 s"));
  EXPECT_THAT(outcome.out, EndsWith("different by position; not judged: orientation_deg, "
                                    "linear_velocity, angular_velocity\n"));
  EXPECT_EQ(compare(a, b, {"--tol", "position=0.51"}).code, 0);
  EXPECT_EQ(compare(a, b, {"--tol", "linear_velocity=0,angular_velocity=0"}).code, 0);
}

TEST_F(ProgramCompare, JudgesEveryQuantityUnlessToldWhich) {
  EXPECT_EQ(compare({"0,p,0"}, {"0,p,2e-9"}).code, 1);
  EXPECT_EQ(compare({"0,p,0"}, {"0,p,5e-10"}).code, 0);
}

TEST_F(ProgramCompare, ATurnIsAnAngle) {
  const std::string header = "time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n";
  // A quarter turn about z, as q and as -q; both stand for the same attitude.
  const std::string q = "0,p,0,0,0,0.7071067811865476,0,0,0.7071067811865476,0,0,0,0,0,0\n";
  const std::string minus = "0,p,0,0,0,-0.7071067811865476,0,0,-0.7071067811865476,0,0,0,0,0,0\n";
  here.write("none.csv", header + "0,p,0,0,0,1,0,0,0,0,0,0,0,0,0\n");
  here.write("q.csv", header + q);
  here.write("minus.csv", header + minus);
  EXPECT_EQ(here.run({"compare", "q.csv", "minus.csv"}).code, 0);
  const Outcome outcome = here.run({"compare", "none.csv", "q.csv", "--tol", "orientation_deg=89"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(lines_of(outcome.out)[5], HasSubstr(" 90 deg "));
}

TEST_F(ProgramCompare, ABodyOrTimesThatOnlyOneHasAreADifference) {
  const Outcome body = compare({"0,p,0", "0,q,0"}, {"0,p,0", "0,r,0"});
  EXPECT_EQ(body.code, 1);
  EXPECT_THAT(body.out, HasSubstr("only in a.csv"));
  EXPECT_THAT(body.out, HasSubstr("only in b.csv"));
  const Outcome times = compare({"0,p,0", "1,p,0", "2,p,0"}, {"0,p,0", "2,p,0", "3,p,0", "4,p,0"});
  EXPECT_EQ(times.code, 1);
  EXPECT_THAT(times.out, HasSubstr("2 times compared, 0 rows only in a.csv, 2 only in b.csv"));
}

TEST_F(ProgramCompare, InterpolatesWhereTheTimesDiffer) {
  const Outcome outcome = compare({"0,p,0", "1,p,2", "2,p,4"}, {"0,p,0", "0.5,p,0.9", "2,p,4"},
                                  {"--tol", "position=0.4"});
  EXPECT_EQ(outcome.code, 0) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("interpolated at 1 of 3 times"));
}

TEST_F(ProgramCompare, TakesFoldersAndTheTolerancesBesideTheGoldenRun) {
  compare({"0,p,0", "0,q,0"}, {"0,p,0.5", "0,q,2"});
  for (const std::string run : {"a", "b"}) {
    std::filesystem::create_directory(here / run);
    here.write(run + "/trajectory.csv", here.read(run + ".csv"));
  }
  EXPECT_EQ(here.run({"compare", "a", "b"}).code, 1);
  here.write("a/tolerances.yaml", "position: 1\nbodies: {q: {position: 3}}\n");
  EXPECT_EQ(here.run({"compare", "a", "b"}).code, 0);
  EXPECT_EQ(here.run({"compare", "b", "a"}).code, 0);
  EXPECT_EQ(here.run({"compare", "a", "b.csv", "--tol", "position=0.1"}).code, 1);
  here.write("close.yaml", "position: 0.1\n");
  EXPECT_EQ(here.run({"compare", "a", "b", "--tolerances", "close.yaml"}).code, 1);
}

TEST_F(ProgramCompare, NamesEveryFaultOfAToleranceFile) {
  here.write("t.yaml", "positon: 1\norientation_deg: -1\nbodies: {q: 3, p: {speed: 1}}\n");
  const Outcome outcome = compare({"0,p,0"}, {"0,p,0"}, {"--tolerances", "t.yaml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("t.yaml:1:1: positon: unknown key; did you mean position?"));
  EXPECT_THAT(outcome.err, HasSubstr("t.yaml:2:18: orientation_deg: found -1, expected"));
  EXPECT_THAT(outcome.err, HasSubstr("t.yaml:3:13: bodies.q: found 3, expected a map of tol"));
  EXPECT_THAT(outcome.err, HasSubstr("bodies.p.speed: unknown key"));
}

TEST_F(ProgramCompare, TellsMachinesInJsonAndJunit) {
  const Outcome outcome = compare({"0,p,0", "1,p,0"}, {"0,p,0", "1,p,0.5"},
                                  {"--tol", "position=0.1", "--json", "--junit", "r.xml"});
  EXPECT_EQ(outcome.code, 1);
  const json told = json::parse(outcome.out);
  EXPECT_EQ(told["same"], false);
  EXPECT_EQ(told["bodies"]["p"]["position"]["largest"], 0.5);
  EXPECT_EQ(told["bodies"]["p"]["position"]["first_beyond"], 1);
  EXPECT_TRUE(told["bodies"]["p"]["linear_velocity"]["tolerance"].is_null());
  const std::string report = here.read("r.xml");
  EXPECT_THAT(report, HasSubstr("tests=\"2\" failures=\"1\""));
  EXPECT_THAT(report, HasSubstr("<testcase classname=\"p\" name=\"times\"/>"));
  EXPECT_THAT(report, HasSubstr("differs by up to 0.5 m at 1 s, tolerance 0.1"));
}

TEST_F(ProgramCompare, WrongInputIsCodeTwo) {
  for (const std::string tolerance : {"speed=1", "forces.buoyance=1", "position.peek=1", "position",
                                      "position=", "position=-1", "position=nan", "position=1x"})
    EXPECT_EQ(compare({"0,p,0"}, {"0,p,0"}, {"--tol", tolerance}).code, 2) << tolerance;
  EXPECT_THAT(compare({"0,p,0"}, {"0,p,0"}, {"--tol", "speed=1"}).err,
              StartsWith("--tol: unknown quantity speed; there are position, orientation_deg, "));
  EXPECT_THAT(compare({"0,p,0"}, {"0,p,0"}, {"--tol", "lines.tensoin=1"}).err,
              StartsWith("--tol: unknown quantity lines.tensoin; did you mean lines.tension?"));
  EXPECT_EQ(compare({"0,p,zero"}, {"0,p,0"}).code, 2);
  EXPECT_EQ(here.run({"compare", "a.csv", "none.csv"}).code, 2);
}

class ProgramRender : public testing::Test {
 protected:
  Workplace here;
};

TEST_F(ProgramRender, GivesThePicturesOfTheRunItself) {
  // The log has its last row before the end of the scene, the run its last step beyond it: that one
  // is not in the log.
  here.write("box.yaml",
             falling_box("1.005", "render: {size: [160, 120], every: 0.2}\nlog: {every: 0.1}\n"));
  ASSERT_EQ(here.run({"run", "box.yaml"}).code, 0);
  const Outcome outcome =
      here.run({"render", "out/box/trajectory.csv", "--scene", "box.yaml", "--out", "again"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const std::string file :
       {"frames/frame_0000.png", "frames/frame_0003.png", "frames/frame_0005.png"}) {
    EXPECT_GT(here.read("again/" + file).size(), 1000u) << file;
    EXPECT_EQ(here.read("again/" + file), here.read("out/box/" + file)) << file;
  }
  EXPECT_TRUE(fs::exists(here / "out/box/frames/frame_0006.png"));
  EXPECT_FALSE(fs::exists(here / "again/frames/frame_0006.png"));
}

TEST_F(ProgramRender, DrawsAsUsualForASceneWithoutARenderBlock) {
  here.write("box.yaml", falling_box("0.4"));
  here.run({"run", "box.yaml"});
  EXPECT_EQ(
      here.run({"render", "out/box/trajectory.csv", "--scene", "box.yaml", "--out", "p"}).code, 0);
  EXPECT_TRUE(fs::exists(here / "p/frames/frame_0001.png"));
}

TEST_F(ProgramRender, FindsTheSceneOfARunByItself) {
  here.write("box.yaml", falling_box("0.4"));
  here.run({"run", "box.yaml", "--set", "bodies[0].color=[1, 0, 0]"});
  EXPECT_EQ(here.run({"render", "out/box", "--out", "p"}).code, 0);
  EXPECT_EQ(here.run({"render", "out/box", "--scene", "box.yaml", "--out", "q", "--set",
                      "bodies[0].color=[1, 0, 0]"})
                .code,
            0);
  EXPECT_GT(here.read("p/frames/frame_0001.png").size(), 1000u);
  EXPECT_EQ(here.read("p/frames/frame_0001.png"), here.read("q/frames/frame_0001.png"));
  fs::remove(here / "out/box/summary.json");
  EXPECT_THAT(here.run({"render", "out/box", "--out", "r"}).err, HasSubstr("name it by --scene"));
}

TEST_F(ProgramRender, RefusesTheTrajectoryOfAnotherScene) {
  here.write("box.yaml", falling_box("0.1"));
  here.run({"run", "box.yaml"});
  here.write("other.yaml", falling_box("0.1"));
  const Outcome outcome = here.run({"render", "out/box/trajectory.csv", "--scene", "other.yaml",
                                    "--out", "p", "--set", "bodies[0].name=other"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(lines_of(outcome.err),
              ElementsAre("out/box/trajectory.csv: has no body other, which the scene has",
                          "out/box/trajectory.csv: has a body box, which the scene does not have",
                          "2 problems."));
  EXPECT_FALSE(fs::exists(here / "p"));
}

TEST_F(ProgramRender, RefusesRowsOfBodiesAtDifferentTimes) {
  const std::string rest = ",0,0,0,1,0,0,0,0,0,0,0,0,0\n";
  here.write("t.csv", "time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n0,a" + rest + "0.5,b" + rest);
  here.write("s.yaml",
             "plimsoll: 1\nduration: 1\nbodies:\n"
             "  - {name: a, box: {size: [1, 1, 1]}, density: 1}\n"
             "  - {name: b, box: {size: [1, 1, 1]}, density: 1}\n");
  const Outcome outcome = here.run({"render", "t.csv", "--scene", "s.yaml", "--out", "p"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err,
              StartsWith("t.csv: row 1 of body a has the time 0 s and that of body b 0.5"));
}

}  // namespace
