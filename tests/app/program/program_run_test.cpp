#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/logs/force_csv.h"
#include "app/logs/read_log.h"
#include "app/logs/trajectory.h"
#include "tests/app/program/program.h"
#include "tests/support/files.h"

/// What `plimsoll run` leaves behind.

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::falling_box;
using support::files_in;
using support::lines_of;
using support::Outcome;
using support::Workplace;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Keys of a JSON object, in their order in the file.
std::vector<std::string> keys(const nlohmann::ordered_json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

const std::string kPictures = "render: {size: [160, 120], every: 0.2}\n";

class ProgramRun : public testing::Test {
 protected:
  Workplace here;
};

TEST_F(ProgramRun, WritesTheTrajectoryFromTimeZeroWithARowAStep) {
  here.write("box.yaml", falling_box("0.5"));
  const Outcome outcome = here.run({"run", "box.yaml"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(here.read("out/box/trajectory.csv"));
  ASSERT_EQ(lines.size(), 1u + 51u);
  EXPECT_EQ(lines[0], "time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz");
  EXPECT_THAT(lines[1], testing::StartsWith("0,box,"));
  const app::BodyTrack track =
      app::read_trajectory(here / "out/box/trajectory.csv").tracks.at("box");
  EXPECT_EQ(track.states[0].linear_velocity, Eigen::Vector3d::Zero());
  EXPECT_EQ(track.states[0].position.z(), 1);
  EXPECT_EQ(track.times.back(), 50 * 0.01);
}

TEST_F(ProgramRun, LogsAsOftenAsTheSceneSays) {
  here.write("box.yaml", falling_box("0.5", "log: {every: 0.1}\n"));
  here.run({"run", "box.yaml"});
  const auto trajectory = app::read_trajectory(here / "out/box/trajectory.csv");
  EXPECT_THAT(trajectory.tracks.at("box").times,
              ElementsAre(0, 10 * 0.01, 20 * 0.01, 30 * 0.01, 40 * 0.01, 50 * 0.01));
}

TEST_F(ProgramRun, WritesASummaryOfWhatItCostAndSkipped) {
  here.write("box.yaml", falling_box("0.5"));
  here.run({"run", "box.yaml"});
  const auto summary = nlohmann::ordered_json::parse(here.read("out/box/summary.json"));
  EXPECT_THAT(keys(summary),
              ElementsAre("version", "scene", "title", "ended", "steps", "simulated_seconds",
                          "real_time_factor", "threads", "warnings", "wall_seconds", "shares",
                          "skipped", "bodies", "source"));
  EXPECT_EQ(summary["scene"], "box.yaml");
  EXPECT_EQ(summary["title"], "Falling box");
  EXPECT_EQ(summary["ended"], "completed");
  EXPECT_EQ(summary["steps"], 50);
  EXPECT_EQ(summary["simulated_seconds"], 50 * 0.01);
  EXPECT_THAT(keys(summary["wall_seconds"]),
              ElementsAre("total", "added_mass", "collision", "hydro", "engine", "render", "log"));
  EXPECT_THAT(keys(summary["shares"]),
              ElementsAre("sea", "loads", "collisions", "constraints", "water", "log"));
  double shares = 0;
  for (const auto& share : summary["shares"]) {
    EXPECT_GE(share, 0);
    shares += share.get<double>();
  }
  EXPECT_LE(shares, 1);
  EXPECT_EQ(summary["skipped"]["collision"], true);
  EXPECT_EQ(summary["skipped"]["water"], false);
  EXPECT_EQ(summary["skipped"]["pictures"], "the scene has no render block");
  EXPECT_EQ(summary["bodies"]["box"]["triangles"], 48);
  EXPECT_THAT(keys(summary["bodies"]["box"]),
              ElementsAre("triangles", "mass", "mesh_digest", "loads_not_computed", "drag_shape",
                          "steps_above_water", "steps_at_rest", "motion", "added_mass", "radiation",
                          "resistance"));
}

TEST_F(ProgramRun, WarnsOfAStepThatIsTooLongForTheWaves) {
  here.write("short.yaml", R"(plimsoll: 1
duration: 2
step: 0.25
water: {surface: {waves: [{amplitude: 0.02, wavelength: 2, heading_deg: 0}]}}
hydro: {added_mass: none}
bodies:
  - {name: raft, box: {size: [4, 3, 1]}, density: 500}
)");
  const Outcome outcome = here.run({"run", "short.yaml"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("short.yaml: warning: body 'raft' meets a wave every 1.1"));
  EXPECT_EQ(here.run({"run", "short.yaml", "--quiet"}).err, "");
}

TEST_F(ProgramRun, WarnsOfWavesThatWouldBreakAndGoesOn) {
  here.write("steep.yaml", R"(plimsoll: 1
duration: 0.1
water: {surface: {waves: [{amplitude: 0.8, wavelength: 10}]}}
)");
  const std::string line =
      "steep.yaml: warning: water.surface.waves[0].amplitude: the height of the wave is 0.16 of "
      "its "
      "length, and waves break from 0.143 on; expected at most 0.714 m\n";
  const Outcome checked = here.run({"check", "steep.yaml"});
  EXPECT_EQ(checked.code, 0);
  EXPECT_THAT(checked.out, HasSubstr(line));
  const Outcome outcome = here.run({"run", "steep.yaml"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr(line));
  EXPECT_EQ(json::parse(here.read("out/steep/summary.json"))["warnings"].size(), 1u);
  EXPECT_EQ(here.run({"run", "steep.yaml", "--quiet"}).err, "");
}

TEST_F(ProgramRun, DrawsFramesAndASheetOfThemAndOfTheFinalState) {
  here.write("box.yaml", falling_box("0.6", kPictures));
  const Outcome outcome = here.run({"run", "box.yaml"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(files_in(here / "out/box"),
              ElementsAre("frames", "sheet.png", "summary.json", "trajectory.csv"));
  EXPECT_THAT(files_in(here / "out/box/frames"),
              ElementsAre("frame_0000.png", "frame_0001.png", "frame_0002.png", "frame_0003.png"));
  const json summary = json::parse(here.read("out/box/summary.json"));
  EXPECT_EQ(summary["pictures"]["frames"], 4);
  EXPECT_EQ(summary["skipped"]["pictures"], false);
}

TEST_F(ProgramRun, DrawsMorePicturesThanASheetHolds) {
  here.write("box.yaml", falling_box("0.6", "render: {size: [64, 48], every: 0.01}\n"));
  EXPECT_EQ(here.run({"run", "box.yaml"}).code, 0);
  EXPECT_EQ(files_in(here / "out/box/frames").size(), 61u);
}

/// The pictures of a folder, frames and sheet, by their names.
std::map<std::string, std::string> pictures_in(const Workplace& here, const fs::path& folder) {
  std::map<std::string, std::string> pictures = {{"sheet.png", here.read(folder / "sheet.png")}};
  for (const std::string& frame : files_in(here / folder / "frames"))
    pictures[frame] = here.read(folder / "frames" / frame);
  return pictures;
}

TEST_F(ProgramRun, DrawsTheSamePicturesWithAnyNumberOfThreads) {
  here.write("box.yaml", falling_box("0.6", "render: {size: [160, 120], every: 0.02}\n"));
  for (const std::string threads : {"1", "2"})
    ASSERT_EQ(here.run({"run", "box.yaml", "--threads", threads, "--out", threads}).code, 0);
  const Outcome later =
      here.run({"render", "1/trajectory.csv", "--scene", "box.yaml", "--out", "later"});
  EXPECT_EQ(later.code, 0) << later.err;
  const std::map<std::string, std::string> once = pictures_in(here, "1");
  EXPECT_EQ(once.size(), 32u);
  for (const auto& [name, bytes] : once) EXPECT_GT(bytes.size(), 1000u) << name;
  EXPECT_TRUE(pictures_in(here, "2") == once);
  EXPECT_TRUE(pictures_in(here, "later") == once);
}

TEST_F(ProgramRun, DrawsNothingUnlessAsked) {
  here.write("box.yaml", falling_box("0.2", kPictures));
  here.write("bare.yaml", falling_box("0.2"));
  EXPECT_EQ(here.run({"run", "box.yaml", "--no-render"}).code, 0);
  EXPECT_EQ(here.run({"run", "bare.yaml"}).code, 0);
  for (const std::string folder : {"out/box", "out/bare"})
    EXPECT_THAT(files_in(here / folder), ElementsAre("summary.json", "trajectory.csv"));
}

TEST_F(ProgramRun, LeavesNothingOfAnEarlierRunInItsFolder) {
  here.write("box.yaml", falling_box("0.6", kPictures));
  here.run({"run", "box.yaml"});
  here.run({"run", "box.yaml", "--set", "duration=0.3"});
  EXPECT_THAT(files_in(here / "out/box/frames"),
              ElementsAre("frame_0000.png", "frame_0001.png", "frame_0002.png"));
  here.write("out/box/notes.txt", "mine");
  here.run({"run", "box.yaml", "--no-render"});
  EXPECT_THAT(files_in(here / "out/box"),
              ElementsAre("notes.txt", "summary.json", "trajectory.csv"));
}

/// Graphics libraries that the loader had to do with in a run, by its own account.
std::vector<std::string> graphics_libraries(const Workplace& here, const std::string& scene) {
  here.run({"run", scene}, {"LD_DEBUG=libs", "LD_DEBUG_OUTPUT=loader"});
  std::vector<std::string> found;
  for (const std::string& file : files_in(here / ".")) {
    if (!file.starts_with("loader.")) continue;
    const std::string text = here.read(file);
    EXPECT_THAT(text, HasSubstr("libode"));  // the account is of this program
    for (const std::string name : {"libEGL", "libGL.", "libGLX", "libOpenGL", "libgbm"})
      if (text.find(name) != std::string::npos) found.push_back(name);
  }
  return found;
}

TEST_F(ProgramRun, TouchesNoGraphicsLibraryWithoutARenderBlock) {
  here.write("bare.yaml", falling_box("0.1"));
  EXPECT_THAT(graphics_libraries(here, "bare.yaml"), IsEmpty());
}

TEST_F(ProgramRun, TouchesAGraphicsLibraryWithARenderBlock) {
  here.write("box.yaml", falling_box("0.1", kPictures));
  EXPECT_THAT(graphics_libraries(here, "box.yaml"), testing::Contains("libEGL"));
}

/// Many bodies that collide in waves: what threads could put in another order.
std::string busy_scene() {
  std::string text =
      "plimsoll: 1\nduration: 0.5\nground: {z: -1}\n"
      "water: {surface: {waves: [{amplitude: 0.2, wavelength: 5}]}}\nhydro: {added_mass: "
      "none}\nbodies:\n";
  for (int i = 0; i < 12; ++i)
    text += "  - {name: b" + std::to_string(i) +
            ", box: {size: [1, 1, 1], divisions: 10}, density: 700, position: [" +
            std::to_string(0.9 * (i % 3)) + ", 0.1, " + std::to_string(1.01 * (i / 3)) + "]}\n";
  return text;
}

TEST_F(ProgramRun, RepeatsItselfToTheByteWithAnyNumberOfThreads) {
  here.write("busy.yaml", busy_scene());
  for (const std::string threads : {"1", "2", "5"})
    ASSERT_EQ(here.run({"run", "busy.yaml", "--threads", threads, "--out", threads}).code, 0);
  ASSERT_EQ(here.run({"run", "busy.yaml", "--out", "again"}).code, 0);
  const std::string once = here.read("1/trajectory.csv");
  EXPECT_GT(once.size(), 10'000u);
  EXPECT_EQ(here.read("2/trajectory.csv"), once);
  EXPECT_EQ(here.read("5/trajectory.csv"), once);
  EXPECT_EQ(here.read("again/trajectory.csv"), once);
}

/// Numbers of a body's rows by the name of their column; the times are there as `time`.
std::map<std::string, std::vector<double>> columns_of(const std::string& log,
                                                      const std::string& body) {
  std::map<std::string, std::vector<double>> columns;
  std::vector<std::string> names;
  for (const std::string& line : lines_of(log)) {
    std::vector<std::string> fields;
    std::stringstream row(line);
    for (std::string field; std::getline(row, field, ',');) fields.push_back(field);
    if (names.empty()) {
      names = fields;
      continue;
    }
    EXPECT_EQ(fields.size(), names.size());
    if (fields.size() != names.size() || fields[1] != body) continue;
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (i != 1) columns[names[i]].push_back(std::stod(fields[i]));
  }
  return columns;
}

TEST_F(ProgramRun, WritesTheForcesBesideTheTrajectory) {
  here.write("box.yaml", falling_box("0.5"));
  here.run({"run", "box.yaml", "--out", "bare"});
  const Outcome outcome = here.run({"run", "box.yaml", "--set", "log.forces=true"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(here.read("out/box/trajectory.csv"), here.read("bare/trajectory.csv"));
  const std::string log = here.read("out/box/forces.csv");
  EXPECT_EQ(lines_of(log).front(), app::force_header());
  auto column = columns_of(log, "box");
  const app::BodyTrack track =
      app::read_trajectory(here / "out/box/trajectory.csv").tracks.at("box");
  EXPECT_EQ(column["time"], track.times);
  EXPECT_EQ(column.size(), 133u);
  // It has fallen into the water, and what the weight gave is in the motion and the water.
  EXPECT_EQ(column["buoyancy_fz"].front(), 0);
  EXPECT_GT(column["buoyancy_fz"].back(), 0);
  const double fallen = track.states.front().position.z() - track.states.back().position.z();
  EXPECT_NEAR(column["work_weight"].back(), -column["weight_fz"].back() * fallen,
              1e-3 * column["work_weight"].back());
  double works = 0;
  for (const auto& [name, values] : column)
    if (name.starts_with("work_")) works += values.back();
  EXPECT_NEAR(column["kinetic_energy"].back(), works, 1e-3 * works);
}

TEST_F(ProgramRun, LogsForcesAsProbeFindsThem) {
  here.write("box.yaml", falling_box("0", "log: {forces: true}\n"));
  const std::vector<std::string> under = {"--set", "bodies[box].position=[0, 0, -0.3]",
                                          "--set", "bodies[box].linear_velocity=[1, 0, -2]",
                                          "--set", "hydro.lift=0.01"};
  const auto with = [&](std::vector<std::string> words) {
    words.insert(words.end(), under.begin(), under.end());
    return here.run(words);
  };
  const json probe = json::parse(with({"probe", "box.yaml"}).out)["bodies"]["box"];
  with({"run", "box.yaml"});
  auto column = columns_of(here.read("out/box/forces.csv"), "box");
  for (const std::string load : {"buoyancy", "pressure_drag", "viscous_drag", "lift"})
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(column[load + "_f" + "xyz"[i]].at(0), probe[load]["force"][i]) << load;
      EXPECT_EQ(column[load + "_t" + "xyz"[i]].at(0), probe[load]["torque"][i]) << load;
    }
  EXPECT_EQ(column["wetted_area"].at(0), probe["wetted_area"]);
  EXPECT_EQ(column["displaced_volume"].at(0), probe["displaced_volume"]);
}

TEST_F(ProgramRun, LeavesNoForcesOfAnEarlierRun) {
  here.write("box.yaml", falling_box("0.2"));
  here.run({"run", "box.yaml", "--set", "log.forces=true"});
  EXPECT_THAT(files_in(here / "out/box"),
              ElementsAre("forces.csv", "summary.json", "trajectory.csv"));
  here.run({"run", "box.yaml"});
  EXPECT_THAT(files_in(here / "out/box"), ElementsAre("summary.json", "trajectory.csv"));
}

TEST_F(ProgramRun, WritesProbesBesideTheTrajectoryAndLeavesNoneOfAnEarlierRun) {
  here.write("box.yaml", falling_box("0.02"));
  const Outcome outcome =
      here.run({"run", "box.yaml", "--set", "log.probes=[{name: g, wave: [1, 2]}]", "--set",
                "log.probes[+].name=p", "--set", "log.probes[p].body=box"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(here.read("out/box/probes.csv"));
  ASSERT_EQ(lines.size(), 7u);
  EXPECT_EQ(lines[0], "time,probe,elevation,x,y,z,vx,vy,vz,ax,ay,az");
  EXPECT_EQ(lines[1], "0,g,0,1,2,0,,,,,,");
  EXPECT_TRUE(lines[2].starts_with("0,p,0,")) << lines[2];
  EXPECT_TRUE(lines[2].ends_with(",,,")) << lines[2];
  EXPECT_EQ(lines[5], "0.02,g,0,1,2,0,,,,,,");
  EXPECT_EQ(lines[6].find(",,"), std::string::npos) << lines[6];
  here.run({"run", "box.yaml"});
  EXPECT_THAT(files_in(here / "out/box"), ElementsAre("summary.json", "trajectory.csv"));
}

TEST_F(ProgramRun, LogsTheSameForcesWithAnyNumberOfThreads) {
  here.write("busy.yaml", busy_scene());
  for (const std::string threads : {"1", "2", "5"})
    ASSERT_EQ(here.run({"run", "busy.yaml", "--threads", threads, "--out", threads, "--set",
                        "log.forces=true"})
                  .code,
              0);
  const std::string once = here.read("1/forces.csv");
  EXPECT_GT(once.size(), 10'000u);
  EXPECT_EQ(here.read("2/forces.csv"), once);
  EXPECT_EQ(here.read("5/forces.csv"), once);
}

TEST_F(ProgramRun, TakesKeysFromTheCommandLine) {
  here.write("box.yaml", falling_box("9"));
  const Outcome outcome = here.run({"run", "box.yaml", "--set", "duration=0.1", "--set",
                                    "bodies[box].position=[0, 0, 7]", "--set", "step=0.05"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto trajectory = app::read_trajectory(here / "out/box/trajectory.csv");
  EXPECT_THAT(trajectory.tracks.at("box").times, ElementsAre(0, 0.05, 0.1));
  EXPECT_EQ(trajectory.tracks.at("box").states[0].position.z(), 7);
}

TEST_F(ProgramRun, OfNoDurationLogsAndDrawsTheInitialState) {
  here.write("box.yaml", falling_box("0", kPictures));
  EXPECT_EQ(here.run({"run", "box.yaml"}).code, 0);
  EXPECT_EQ(lines_of(here.read("out/box/trajectory.csv")).size(), 2u);
  EXPECT_THAT(files_in(here / "out/box/frames"), ElementsAre("frame_0000.png"));
}

TEST_F(ProgramRun, OfNoBodiesIsARun) {
  here.write("sea.yaml", "plimsoll: 1\nduration: 0.1\nwater: {}\n" + kPictures);
  const Outcome outcome = here.run({"run", "sea.yaml"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(lines_of(here.read("out/sea/trajectory.csv")).size(), 1u);
}

TEST_F(ProgramRun, FindsItsFilesFromAnyFolderAndWithAnyName) {
  const std::string mesh =
      "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  here.write("a b/mesh é/tetra hedron.obj", mesh);
  here.write("a b/my scène.yaml",
             "plimsoll: 1\nduration: 0.1\nbodies:\n  - {name: Blåhaj the 鯊, density: 500, "
             "mesh: {file: mesh é/tetra hedron.obj}}\n");
  const Outcome outcome = here.run({"run", "a b/my scène.yaml", "--out", "new folder/ö"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto trajectory = app::read_trajectory(here / "new folder/ö/trajectory.csv");
  EXPECT_THAT(trajectory.names, ElementsAre("Blåhaj the 鯊"));
  EXPECT_EQ(here.shell("cd 'a b' && mkdir x && cd x && $PLIMSOLL run '../my scène.yaml'").code, 0);
  EXPECT_TRUE(fs::exists(here / "a b/x/out/my scène/summary.json"));
}

TEST_F(ProgramRun, OfAFileWhoseNameIsNoUtf8WritesItsSummary) {
  here.write("b\xe9.yaml", falling_box("0.1"));
  const Outcome outcome = here.run({"run", "b\xe9.yaml", "--out", "o"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(json::parse(here.read("o/summary.json"))["scene"], "b\uFFFD.yaml");
}

TEST_F(ProgramRun, SaysNothingWhenQuietAndShowsNoProgressOutsideATerminal) {
  here.write("box.yaml", falling_box("0.5"));
  const Outcome loud = here.run({"run", "box.yaml"});
  EXPECT_THAT(loud.err, HasSubstr("out/box: 50 steps, 0.5 s simulated in "));
  EXPECT_THAT(loud.err, HasSubstr(" s (added mass and radiation "));
  EXPECT_THAT(loud.err, Not(HasSubstr("\r")));
  EXPECT_EQ(loud.out, "");
  const Outcome quiet = here.run({"run", "box.yaml", "--quiet"});
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(ProgramRun, SaysWhatItMadeOfTheSceneBeforeTheRestOfItsReport) {
  here.write("box.yaml", falling_box("0.5"));
  const std::string said = here.run({"run", "box.yaml", "--no-render"}).err;
  EXPECT_THAT(said, testing::StartsWith("box: 1 body; 0.5 s in steps of 0.01 s; water of "));
  const std::size_t omitted = said.find(
      "  not computed: collisions (nothing can collide); added mass of box (added_mass: none); "
      "pictures (");
  ASSERT_NE(omitted, std::string::npos) << said;
  EXPECT_LT(omitted, said.find("out/box: 50 steps"));
}

TEST_F(ProgramRun, ShowsItsProgressInALineOfATerminalHoweverNarrow) {
  if (here.shell("command -v script").code != 0) GTEST_SKIP() << "there is no script(1)";
  here.write("box.yaml", falling_box("0.5"));
  const auto first_shown = [&](const std::string& columns) {
    const Outcome outcome =
        here.shell("script -qec \"stty cols " + columns + "; $PLIMSOLL run box.yaml\" /dev/null");
    const std::string begin = "\r\033[K";
    const std::size_t first = outcome.out.find(begin) + begin.size();
    return outcome.out.substr(first, outcome.out.find(begin, first) - first);
  };
  EXPECT_THAT(
      first_shown("100"),
      testing::MatchesRegex("box: 0\\.[0-9]+ of 0\\.5 s +[0-9]+ %  .+ x real time  .+ left"));
  EXPECT_EQ(first_shown("20").size(), 19u);
}

TEST_F(ProgramRun, DoesNotMindStreamsThatAreClosedOrFull) {
  here.write("box.yaml", falling_box("0.5"));
  here.run({"run", "box.yaml"});
  const std::string expected = here.read("out/box/trajectory.csv");
  for (const std::string streams : {">&- 2>&-", "<&- >&- 2>&-", "2>/dev/full"}) {
    EXPECT_EQ(here.shell("$PLIMSOLL run box.yaml " + streams).code, 0) << streams;
    EXPECT_EQ(here.read("out/box/trajectory.csv"), expected);
  }
}

}  // namespace
