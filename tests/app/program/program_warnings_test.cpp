#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program/program.h"

/// What a run tells of its own errors: in the terminal and in summary.json.

namespace {

using nlohmann::json;
using support::Outcome;
using support::Workplace;
using testing::HasSubstr;
using testing::Not;

class ProgramWarnings : public testing::Test {
 protected:
  Outcome run(const std::string& text) const {
    here.write("scene.yaml", "plimsoll: 1\n" + text);
    const Outcome outcome = here.run({"run", "scene.yaml", "--out", "o"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome;
  }
  json summary() const { return json::parse(here.read("o/summary.json")); }

  Workplace here;
};

TEST_F(ProgramWarnings, TellHowDeepACrateIsPressedIntoTheGround) {
  const Outcome outcome =
      run("duration: 3\nground: {z: 0}\nbodies:\n"
          "  - {name: crate, box: {size: [1, 1, 1]}, mass: 100, position: [0, 0, 0.05]}\n"
          "  - {name: block, box: {size: [1, 1, 1]}, mass: 10000, position: [0, 0, 1.05]}\n");
  const std::string told = "crate and ground overlapped by 0.45 m at ";
  EXPECT_THAT(outcome.err, HasSubstr("scene.yaml: warning: " + told));
  EXPECT_THAT(outcome.err, HasSubstr("\n  largest overlaps: crate and ground 0.45 m at "));
  EXPECT_THAT(summary()["warnings"].dump(), HasSubstr(told));
  const json overlaps = summary()["overlaps"];
  EXPECT_EQ(overlaps["pairs"], 2);
  EXPECT_EQ(overlaps["largest"][0]["bodies"], json({"crate", "ground"}));
  EXPECT_NEAR(overlaps["largest"][0]["depth"], 0.45, 1e-3) << "as deep as it begins";
  EXPECT_EQ(overlaps["largest"][1]["bodies"], json({"block", "crate"}));
}

TEST_F(ProgramWarnings, TellNothingOfCratesThatLieAndHangAsTheyShould) {
  const Outcome outcome = run(
      "duration: 1\nground: {z: 0}\nbodies:\n"
      "  - {name: crate, box: {size: [1, 1, 1]}, mass: 100, position: [0, 0, 0.5]}\n"
      "  - {name: lamp, box: {size: [1, 1, 1]}, mass: 100, position: [9, 0, 3]}\n"
      "  - {name: shade, box: {size: [1, 1, 1]}, mass: 100, position: [9, 0, 1.8]}\n"
      "joints:\n"
      "  - {name: eye, type: ball, bodies: [lamp, world], anchor: [9, 0, 4]}\n"
      "  - {name: pin, type: hinge, bodies: [shade, lamp], anchor: [9, 0, 2.4], axis: [0, 1, 0]}\n"
      "log: {forces: true}\n");
  EXPECT_THAT(outcome.err, Not(HasSubstr("warning")));
  EXPECT_EQ(summary()["warnings"], json::array());
  const json joints = summary()["joints"];
  EXPECT_LT(joints["eye"]["position_error_max"].get<double>(), 1e-6);
  EXPECT_FALSE(joints["eye"].contains("angle_error_max_deg"));
  EXPECT_LT(joints["pin"]["angle_error_max_deg"].get<double>(), 1e-6);
  EXPECT_EQ(summary()["bodies"]["lamp"]["motion"]["clamped_work_share"], 0);
}

// What drags a body of 50 mm about its hinge by a whole turn a step, and a needle of a millimetre
// that is welded to a float.
TEST_F(ProgramWarnings, TellNothingOfJointsThatHoldInAStream) {
  const Outcome outcome =
      run("duration: 4\nstep: 0.05\nwater: {current: [-2.9, 3.1, 0]}\n"
          "hydro: {added_mass: none, pressure_drag: 20}\nbodies:\n"
          "  - {name: vane, box: {size: [0.05, 0.03, 0.02]}, density: 7000, angular_velocity: "
          "[0, 0, 125.7], position: [0.027, 0, -0.04]}\n"
          "  - {name: float, box: {size: [0.3, 0.3, 0.3]}, density: 500, position: [9, 0, 0]}\n"
          "  - {name: needle, box: {size: [1, 0.001, 0.001]}, density: 800, position: [9.5, 0, "
          "-0.1], collision: none}\n"
          "joints:\n"
          "  - {name: pin, type: hinge, bodies: [vane, world], anchor: [0, 0, -0.04], axis: [0, "
          "0.1, 1]}\n"
          "  - {name: weld, type: fixed, bodies: [needle, float], anchor: [9.1, 0, -0.1]}\n");
  EXPECT_THAT(outcome.err, Not(HasSubstr("came apart")));
  const json joints = summary()["joints"];
  for (const char* joint : {"pin", "weld"}) {
    EXPECT_LT(joints[joint]["position_error_max"].get<double>(), 1e-9) << joint << " [m]";
    EXPECT_LT(joints[joint]["angle_error_max_deg"].get<double>(), 1e-6) << joint;
  }
}

TEST_F(ProgramWarnings, TellADrivenHullThatGoesTooFastForWhatIsComputed) {
  const Outcome outcome =
      run("duration: 30\nstep: 0.05\nwater: {density: 1000}\n"
          "hydro: {added_mass: none, pressure_drag: false}\nbodies:\n"
          "  - {name: hull, box: {size: [4, 1, 1]}, mass: 2000, forces: [{force: [150, 0, 0]}]}\n");
  const std::string told = "body 'hull' goes through the water at 1.3 m/s at ";
  EXPECT_THAT(outcome.err, HasSubstr("scene.yaml: warning: " + told));
  ASSERT_EQ(summary()["warnings"].size(), 1u);
  EXPECT_THAT(summary()["warnings"].dump(), HasSubstr(told));
}

}  // namespace
