#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/logs/read_log.h"
#include "app/logs/trajectory.h"
#include "tests/app/program/page.h"
#include "tests/app/program/program.h"

/// The data that `plimsoll report` puts into its page, and what it says when it cannot.

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::falling_box;
using support::Outcome;
using support::packed_numbers;
using support::Workplace;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// A tetrahedron, closed, normals outward.
const std::string kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

constexpr double kRounding = 1e-9;  // [kg], of density times volume

class ProgramReport : public testing::Test {
 protected:
  ProgramReport() { support::lay_out_page(here, "page.html"); }

  /// Runs a falling box for half a second into the folder `o`.
  void run_box(const std::string& more = "", const std::string& text = "") {
    here.write("box.yaml", text.empty() ? falling_box("0.5", more) : text);
    const Outcome outcome = here.run({"run", "box.yaml", "--out", "o", "--quiet"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }

  Outcome report(const std::string& arguments) const {
    return here.shell("bin/plimsoll report " + arguments);
  }

  /// The data in the page of the run in `o`.
  json data(const std::string& arguments = "o") const {
    const Outcome outcome = report(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return support::data_in_page(here.read("o/report.html"));
  }

  /// A report that is refused: code 2 and one line that says why.
  std::string fault_of(const std::string& arguments) const {
    const Outcome outcome = report(arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_FALSE(fs::exists(here / "o/report.html"));
    const std::vector<std::string> lines = support::lines_of(outcome.err);
    EXPECT_EQ(lines.size(), 2u) << outcome.err;
    return lines.empty() ? "" : lines[0];
  }

  Workplace here;
};

TEST_F(ProgramReport, HasWhatTheRunWas) {
  run_box();
  const json page = data();
  EXPECT_EQ(page["title"], "Falling box");
  EXPECT_EQ(page["rows"], 51);
  EXPECT_EQ(page["summary"]["steps"], 50);
  EXPECT_FALSE(page["summary"].contains("source"));
  EXPECT_EQ(page["scene"]["text"], falling_box("0.5"));
  EXPECT_EQ(page["scene"]["file"], fs::canonical(here / "box.yaml").string());
  ASSERT_EQ(page["bodies"].size(), 1u);
  EXPECT_EQ(page["bodies"][0]["name"], "box");
  EXPECT_NEAR(page["bodies"][0]["mass"].get<double>(), 500, kRounding);
  EXPECT_EQ(page["shapes"][0]["of_faces"], 48);
  EXPECT_EQ(page["water"]["kind"], "flat");
  EXPECT_TRUE(page["frames"].is_null());
  EXPECT_TRUE(page["ground"].is_null());
  EXPECT_EQ(page["series"]["forces"], false);
  EXPECT_EQ(page["series"]["thinned"], false);
}

TEST_F(ProgramReport, HasWhatTheRunWarnedOf) {
  run_box("",
          "plimsoll: 1\nduration: 30\nstep: 0.05\nwater: {density: 1000}\n"
          "hydro: {added_mass: none, pressure_drag: false}\nbodies:\n"
          "  - {name: hull, box: {size: [4, 1, 1]}, mass: 2000, forces: [{force: [150, 0, 0]}]}\n");
  const json warnings = data()["summary"]["warnings"];
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0].get<std::string>(),
              HasSubstr("body 'hull' goes through the water at 1.3 m/s at "));
}

TEST_F(ProgramReport, HasTheLoadsOfABodyThatIsHeld) {
  run_box("",
          "plimsoll: 1\nduration: 0.5\nstep: 0.1\nwater: {density: 1000}\ngravity: 10\n"
          "hydro: {added_mass: none}\nbodies:\n"
          "  - {name: pier, box: {size: [2, 3, 4]}, mass: 500, lock: all}\n"
          "log: {forces: true, probes: [{name: foot, body: pier, at: [0, 0, -1]}]}\n"
          "render: {size: [320, 240], every: 0.5, pressure: {max: auto}}\n");
  const json page = data();
  const auto logged = [&](const char* column) {
    const std::vector<std::string> names = page["series"]["columns"];
    const auto at = static_cast<std::size_t>(std::ranges::find(names, column) - names.begin());
    const json& series = page["series"]["bodies"][0].at(at);
    // A column that does not change is one number.
    if (series.is_number()) return series.get<double>();
    return series["base"].get<double>() + packed_numbers<float>(series["data"]).back();
  };
  EXPECT_NEAR(logged("buoyancy_fz"), 2 * 3 * 2 * 1e4, 1e-2);
  EXPECT_NEAR(logged("constraint_fz"), 5000 - 2 * 3 * 2 * 1e4, 1e-2);
  EXPECT_NEAR(page["summary"]["pictures"]["pressure_max"].get<double>(), 2e4, 1e-6);
  EXPECT_THAT(here.read("o/probes.csv"), HasSubstr("\n0.5,foot,0,0,0,-1,0,0,0,"));
}

TEST_F(ProgramReport, HasTheLoggedMotion) {
  run_box();
  const json page = data();
  const app::BodyTrack track = app::read_trajectory(here / "o/trajectory.csv").tracks.at("box");
  const std::vector<std::string> names = page["series"]["columns"];
  EXPECT_THAT(names, ElementsAre("x", "y", "z", "roll", "pitch", "yaw", "vx", "vy", "vz", "wx",
                                 "wy", "wz"));
  const json& z = page["series"]["bodies"][0][2];
  const std::vector<float> differences = packed_numbers<float>(z["data"]);
  const std::vector<float> poses = packed_numbers<float>(page["poses"]["bodies"][0]);
  ASSERT_EQ(differences.size(), track.states.size());
  ASSERT_EQ(poses.size(), 7 * track.states.size());
  constexpr double kFloat = 1e-7;  // of a box that moves by metres
  for (std::size_t i = 0; i < track.states.size(); ++i) {
    const double height = track.states[i].position.z();
    EXPECT_NEAR(z["base"].get<double>() + differences[i], height, kFloat);
    EXPECT_NEAR(page["origin"][2].get<double>() + poses[7 * i + 2], height, kFloat);
    EXPECT_NEAR(poses[7 * i + 6], track.states[i].orientation.w(), kFloat);
  }
}

TEST_F(ProgramReport, HasWhatAnalyseFinds) {
  run_box("log: {probes: [{name: gauge, wave: [2, 0]}]}\n");
  const json page = data()["analysis"];
  const json all = json::parse(here.run({"analyse", "o", "--json"}).out);
  EXPECT_EQ(page["wave"], "");
  ASSERT_EQ(page["signals"].size(), 7u);  // six motions, and the elevation
  ASSERT_EQ(all["signals"].size(), 7u);
  for (std::size_t i = 0; i < page["signals"].size(); ++i) {
    const json& shown = page["signals"][i];
    const json& found = all["signals"][i];
    EXPECT_EQ(shown["of"], found["of"]);
    EXPECT_EQ(shown["signal"], found["signal"]);
    EXPECT_EQ(shown["statistics"], found["statistics"]);
    EXPECT_EQ(shown.contains("spectrum"), found.contains("spectrum"));
  }
  const json& shown = page["signals"][2]["spectrum"];
  const json& found = all["signals"][2]["spectrum"];
  EXPECT_EQ(shown["peak_period"], found["peak_period"]);
  EXPECT_EQ(shown["significant_height"], found["significant_height"]);
  const std::vector<float> density = packed_numbers<float>(shown["density"]);
  ASSERT_GT(density.size(), 2u);
  for (std::size_t k = 0; k < density.size(); ++k) {
    EXPECT_FLOAT_EQ(density[k], found["density"][k].get<float>());
    EXPECT_DOUBLE_EQ(shown["step"].get<double>() * static_cast<double>(k),
                     found["frequency_hz"][k].get<double>());
  }
}

TEST_F(ProgramReport, HasDecaysAndResponses) {
  run_box(
      "",
      "plimsoll: 1\nduration: 6\nstep: 0.02\n"
      "water: {surface: {spectrum: {type: jonswap, significant_height: 0.02, peak_period: 1.5}}}\n"
      "hydro: {added_mass: none}\n"
      "bodies: [{name: box, box: {size: [1, 1, 1]}, density: 500}]\n");
  const json in_waves = data()["analysis"];
  EXPECT_EQ(in_waves["wave"], "the wave at its mean place");
  const json& response = in_waves["signals"][2]["response"];
  const std::vector<float> amplitude = packed_numbers<float>(response["amplitude"]);
  EXPECT_GT(amplitude.size(), 2u);
  for (const char* column : {"phase_deg", "coherence", "wave"})
    EXPECT_EQ(packed_numbers<float>(response[column]).size(), amplitude.size()) << column;
  fs::remove_all(here / "o");
  run_box("",
          "plimsoll: 1\nduration: 10\nstep: 0.02\nwater: {}\n"
          "hydro: {added_mass: none}\n"
          "bodies: [{name: box, cylinder: {radius: 0.5, height: 4}, density: 500, "
          "position: [0, 0, 0.3]}]\n");
  const json decay = data()["analysis"]["signals"][2]["decay"];
  const json all = json::parse(here.run({"analyse", "o", "--json"}).out);
  ASSERT_TRUE(decay.is_object());
  EXPECT_EQ(decay, all["signals"][2]["decay"]);
}

TEST_F(ProgramReport, HasNoAnalysisOfARunThatIsTooShort) {
  here.write("box.yaml", falling_box("0.14"));  // 15 rows
  ASSERT_EQ(here.run({"run", "box.yaml", "--out", "o", "--quiet"}).code, 0);
  EXPECT_TRUE(data()["analysis"].is_null());
  ASSERT_EQ(here.run({"run", "box.yaml", "--out", "o", "--quiet", "--set", "duration=0.15"}).code,
            0);
  EXPECT_FALSE(data()["analysis"].is_null());
}

TEST_F(ProgramReport, HasTheForcesWhereTheyWereLogged) {
  run_box("log: {forces: true}\n");
  const json page = data();
  EXPECT_EQ(page["series"]["forces"], true);
  const std::vector<std::string> names = page["series"]["columns"];
  const auto column = [&](const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return page["series"]["bodies"][0][static_cast<std::size_t>(found - names.begin())];
  };
  constexpr double kGravity = 9.80665;
  EXPECT_NEAR(column("weight_fz").get<double>(), -500 * kGravity, 1e-9);  // always the same
  EXPECT_TRUE(column("buoyancy_fz").is_object());
  EXPECT_TRUE(column("work_brake").is_number());
}

TEST_F(ProgramReport, HasWavesAndPicturesWithTheirTimes) {
  run_box("",
          "plimsoll: 1\nduration: 0.6\nstep: 0.01\n"
          "water: {surface: {waves: [{amplitude: 0.1, wavelength: 5}]}}\n"
          "hydro: {added_mass: none}\n"
          "ground: {z: -4}\n"
          "bodies: [{name: box, box: {size: [1, 1, 1]}, density: 500}]\n"
          "render: {size: [64, 48], every: 0.2}\n");
  const json page = data();
  EXPECT_EQ(page["water"]["kind"], "waves");
  EXPECT_EQ(page["ground"]["z"], -4);
  EXPECT_EQ(page["frames"]["of"], 4);
  EXPECT_THAT(page["frames"]["times"].get<std::vector<double>>(),
              ElementsAre(0, 20 * 0.01, 40 * 0.01, 60 * 0.01));
  EXPECT_THAT(page["frames"]["images"][2].get<std::string>(), StartsWith("iVBORw0KGgo"));
}

TEST_F(ProgramReport, HasTheSceneAsItWasRun) {
  here.write("box.yaml", falling_box("9"));
  here.run({"run", "box.yaml", "--out", "o", "--quiet", "--set", "duration=0.1", "--set",
            "bodies[box].density=700"});
  here.write("box.yaml", falling_box("3") + "# edited since\n");
  const json page = data();
  EXPECT_EQ(page["rows"], 11);
  EXPECT_NEAR(page["bodies"][0]["mass"].get<double>(), 700, kRounding);
  EXPECT_EQ(page["scene"]["text"], falling_box("9"));
  EXPECT_THAT(page["scene"]["overrides"].get<std::vector<std::string>>(),
              ElementsAre("duration=0.1", "bodies[box].density=700"));
}

TEST_F(ProgramReport, KeepsWhateverATextHoldsInsideTheData) {
  run_box("",
          "plimsoll: 1\ntitle: '</script><!-- <b>&amp;'\nduration: 0\n"
          "bodies: [{name: 'a</script>', box: {size: [1, 1, 1]}, density: 500}]\n");
  const json page = data();
  EXPECT_EQ(page["title"], "</script><!-- <b>&amp;");
  EXPECT_EQ(page["bodies"][0]["name"], "a</script>");
}

TEST_F(ProgramReport, NeedsNoSceneFileUnlessItNamesOthers) {
  run_box();
  fs::remove(here / "box.yaml");
  EXPECT_EQ(data()["rows"], 51);
}

TEST_F(ProgramReport, SaysThatTheSceneIsNoLongerThereAndFindsItWhereItIs) {
  here.write("scenes/meshes/t.obj", kTetrahedron);
  here.write("scenes/t.yaml",
             "plimsoll: 1\nduration: 0.1\n"
             "bodies: [{name: t, mesh: {file: meshes/t.obj}, density: 500}]\n");
  ASSERT_EQ(here.run({"run", "scenes/t.yaml", "--out", "o", "--quiet"}).code, 0);
  fs::rename(here / "scenes", here / "away");
  EXPECT_THAT(fault_of("o"), HasSubstr("scenes/t.yaml and the files it names no longer exist; name "
                                       "the present place of the scene by report --scene"));
  EXPECT_THAT(fault_of("o --scene none.yaml"), StartsWith("none.yaml: "));
  EXPECT_EQ(data("o --scene away/t.yaml")["shapes"][0]["faces"], 4);
}

TEST_F(ProgramReport, ReadsARunThatWasKilledWithItsSceneNamed) {
  run_box();
  fs::remove(here / "o/summary.json");
  EXPECT_THAT(fault_of("o"), HasSubstr("summary.json: is missing: the run was stopped; name its "
                                       "scene by report --scene"));
  const json page = data("o --scene box.yaml");
  EXPECT_TRUE(page["summary"].is_null());
  EXPECT_EQ(page["rows"], 51);
}

TEST_F(ProgramReport, LeavesOutRowsThatAreOnlyInOneLog) {
  run_box("log: {forces: true}\n");
  const std::string forces = here.read("o/forces.csv");
  here.write("o/forces.csv", forces.substr(0, forces.rfind("\n0.5,") + 1));
  EXPECT_EQ(data()["rows"], 50);
}

TEST_F(ProgramReport, RefusesAFolderThatIsNoRun) {
  EXPECT_THAT(fault_of("none"), StartsWith("none: there is no such folder; expected one"));
  here.write("o/notes.txt", "");
  EXPECT_THAT(fault_of("o"), StartsWith("o/trajectory.csv: cannot be read; expected a trajectory"));
}

TEST_F(ProgramReport, RefusesLogsThatAreBrokenAndSaysWhere) {
  run_box("log: {forces: true}\n");
  const std::string trajectory = here.read("o/trajectory.csv");
  here.write("o/trajectory.csv", trajectory + "0.51,box,1,2\n");
  EXPECT_THAT(fault_of("o"), StartsWith("o/trajectory.csv:53:1: found 4 fields, expected 15"));
  here.write("o/trajectory.csv", trajectory);
  const std::string forces = here.read("o/forces.csv");
  here.write("o/forces.csv", "time,body,drag\n0,box,1\n");
  EXPECT_THAT(fault_of("o"),
              StartsWith("o/forces.csv:1:1: expected the header time,body,buoyancy"));
  std::string shifted = forces;
  shifted.replace(shifted.find("\n0.01,"), 6, "\n0.011,");
  here.write("o/forces.csv", shifted);
  EXPECT_THAT(fault_of("o"), HasSubstr("row 2 of body box has the time 0.011 s and that of "
                                       "trajectory.csv 0.01 s"));
}

TEST_F(ProgramReport, RefusesASummaryThatIsBroken) {
  run_box();
  here.write("o/summary.json", "{\"version\": ");
  EXPECT_THAT(fault_of("o"), StartsWith("o/summary.json: is no summary"));
  here.write("o/summary.json", "{\"source\": {\"file\": 7}}");
  EXPECT_THAT(fault_of("o"), StartsWith("o/summary.json: source: expected file, text and"));
}

TEST_F(ProgramReport, SaysHowToGetAPageThatWasNotBuilt) {
  run_box();
  fs::remove(here / "share/plimsoll/report/page.html");
  EXPECT_THAT(fault_of("o"), HasSubstr("for which npm is needed; run tools/report, or install npm "
                                       "and build the target report_page"));
}

TEST_F(ProgramReport, IsRemovedByALaterRunIntoTheFolder) {
  run_box();
  data();
  run_box();
  EXPECT_FALSE(fs::exists(here / "o/report.html"));
}

}  // namespace
