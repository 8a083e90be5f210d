#include "app/assembly/radiation_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/assembly/build.h"
#include "tests/app/scene_text.h"
#include "tests/support/tolerance.h"

namespace {

using assembly::RadiationChoice;
using support::tolerance;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A raft that floats with its middle at the water, with more keys of its own; and more blocks.
std::string raft(const std::string& keys = "", const std::string& blocks = "") {
  return "plimsoll: 1\nduration: 1\n" + blocks +
         (blocks.find("water:") == std::string::npos ? "water: {density: 1000}\n" : "") +
         "bodies:\n  - {name: raft, box: {size: [4, 2, 1]}, density: 500" +
         (keys.empty() ? "" : ", " + keys) + "}\n";
}

assembly::BuiltScene unsolved(const std::string& text) {
  return assembly::build_without_added_mass(support::read_scene_text(text));
}

RadiationChoice choice(const std::string& text) { return unsolved(text).radiation.at(0).choice; }

/// Why a raft makes no waves.
std::string reason(const std::string& keys, const std::string& blocks = "") {
  const RadiationChoice c = choice(raft(keys, blocks));
  EXPECT_EQ(c.pose.has_value(), c.reason.empty());
  return c.reason;
}

/// The faults of a raft with `radiation: auto`.
std::string fault(const std::string& keys, const std::string& blocks = "",
                  const std::string& hydro = "") {
  try {
    unsolved(
        raft(keys + (keys.empty() ? "" : ", ") + "hydro: {radiation: auto" + hydro + "}", blocks));
  } catch (const scene::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RadiationChoice, IsTheMeanPoseOfABodyThatStartsAfloat) {
  const RadiationChoice c = choice(
      raft("position: [3, 4, 0.05], orientation: {euler_deg: [10, 5, 40]}, collision: none"));
  ASSERT_TRUE(c.pose);
  // The pose is rounded to 1e-7 of the radius and of a radian.
  EXPECT_NEAR(c.pose->height, 0, tolerance(1e-6));
  EXPECT_LT(c.pose->orientation.angularDistance(Eigen::Quaterniond::Identity()), tolerance(1e-6));
  EXPECT_NEAR(c.draught, 0.5, tolerance(1e-6));
  EXPECT_NEAR(c.length, 4, tolerance(1e-6));
  EXPECT_FALSE(c.written);
}

TEST(RadiationChoice, IsTheSameForBodiesThatDifferInPlaceHeadingAndRoundOff) {
  const RadiationChoice a = choice(raft("orientation: {euler_deg: [4, 3, 20]}"));
  const RadiationChoice b =
      choice(raft("position: [9, 1, 0.02], orientation: {euler_deg: [-3, 1, 170]}"));
  EXPECT_EQ(*a.pose, *b.pose);
}

TEST(RadiationChoice, NeedsAStartAfloatUnlessItIsWritten) {
  EXPECT_EQ(reason(""), "");
  EXPECT_EQ(reason("position: [0, 0, 0.6]"), "it starts dry");
  EXPECT_THAT(reason("position: [0, 0, 0.2]"), HasSubstr("displaces 0.6 of its mass"));
  EXPECT_THAT(reason("position: [0, 0, -9]"), HasSubstr("displaces 2 of its mass"));
  EXPECT_EQ(reason("position: [0, 0, 9], start: equilibrium"), "");
  EXPECT_THAT(reason("orientation: {euler_deg: [20, 0, 0]}"), HasSubstr("it starts 20° from"));
  EXPECT_THAT(reason("linear_velocity: [0.7, 0, 0]"), HasSubstr("Froude number of 0.11"));
  EXPECT_EQ(reason("lock: [z]"), "its height is locked");
  for (const char* keys : {"position: [0, 0, 0.6]", "orientation: {euler_deg: [20, 0, 0]}",
                           "linear_velocity: [0.7, 0, 0]", "lock: [z]"})
    EXPECT_EQ(fault(keys), "") << keys;
}

TEST(RadiationChoice, NeedsOpenWaterOfOneDepthUnlessItIsWritten) {
  EXPECT_EQ(reason("", "ground: {z: -1.9}\n"), "ground is near");
  EXPECT_EQ(reason("", "ground: {z: -2.1}\n"), "");
  EXPECT_EQ(fault("", "ground: {z: -1.9}\n"), "");
  EXPECT_EQ(reason("", "water: {depth: 0.6}\n"), "");
  EXPECT_EQ(reason("", "water: {depth: 1.9}\nground: {z: -1.9}\n"), "");
  EXPECT_EQ(reason("", "water: {depth: 1.9}\nground: {z: -1.8}\n"), "ground is near");
  const std::string two =
      raft() + "  - {name: other, sphere: {radius: 1}, density: 3000, position: [0, 3.1, 0]}\n";
  EXPECT_THAT(choice(two).reason, HasSubstr("another body"));
  EXPECT_THAT(choice(raft() + "joints: [{type: hinge, name: pin, bodies: [raft, world],"
                              " anchor: [0, 0, 0], axis: [0, 1, 0]}]\n")
                  .reason,
              HasSubstr("it hangs on pin"));
}

TEST(RadiationChoice, IsAFaultAtTheKeyWhereThereIsNoTheory) {
  const auto is_told = [](const std::string& keys, const std::string& blocks,
                          const std::string& hydro, const std::string& why) {
    EXPECT_THAT(fault(keys, blocks, hydro), HasSubstr(why));
    EXPECT_THAT(fault(keys, blocks, hydro), HasSubstr("bodies[0].hydro.radiation: found auto"));
  };
  is_told("", "water: {depth: 0.49}\n", "", "its draught of 0.5 m reaches the bottom");
  is_told("", "water: {surface: {waves: [{amplitude: 1, period: 9}], kinematics: hydrostatic}}\n",
          "", "kinematics: hydrostatic");
  is_told("", "integrator: {method: ode}\n", "", "method: ode");
  is_told("lock: all", "", "", "held in all six");
  is_told("", "", ", buoyancy: false", "hydro.buoyancy is switched off");
  is_told("", "", ", added_mass: deep", "hydro.added_mass is given");
  is_told("", "water: {density: 400}\n", "", "it sinks");
  is_told("lock: [z], position: [0, 0, 2]", "", "", "its height is locked where it is dry");
  is_told("lock: [z], position: [0, 0, -2]", "", "", "its height is locked where it is submerged");
}

TEST(RadiationChoice, KeepsTheAttitudeOfABodyToWhichItDoesNotMatter) {
  for (const char* shape : {"sphere: {radius: 5}", "icosphere: {radius: 5}"}) {
    const RadiationChoice c =
        choice("plimsoll: 1\nduration: 1\nwater: {}\nbodies:\n  - {name: ball, " +
               std::string(shape) + ", density: 500, orientation: {euler_deg: [40, 30, 0]}}\n");
    ASSERT_TRUE(c.pose) << c.reason;
    EXPECT_NEAR(c.draught, 5, 0.02);  // Of a polyhedron.
  }
}

TEST(RadiationChoice, KeepsWhatIsLocked) {
  const RadiationChoice held =
      choice(raft("orientation: {euler_deg: [5, 0, 0]}, lock: [roll], hydro: {radiation: auto}"));
  EXPECT_NEAR(held.pose->orientation.angularDistance(Eigen::Quaterniond::Identity()),
              5 * M_PI / 180, tolerance(1e-6));
  EXPECT_NEAR(choice(raft("position: [0, 0, 0.3], lock: [z], hydro: {radiation: auto}")).draught,
              0.2, tolerance(1e-6));
}

TEST(RadiationChoice, IsToldOnceForBodiesThatAreAlike) {
  const assembly::BuiltScene built =
      unsolved(raft() +
               "  - {name: high, sphere: {radius: 1}, density: 500, position: [0, 30, 2]}\n"
               "  - {name: higher, sphere: {radius: 1}, density: 500, position: [0, 60, 4]}\n"
               "  - {name: silent, sphere: {radius: 1}, density: 500, hydro: {radiation: none}}\n");
  std::vector<RadiationChoice> choices;
  for (const assembly::RadiationReport& report : built.radiation) choices.push_back(report.choice);
  choices[0].pose.reset();
  choices[0].reason = "of a cause";
  EXPECT_THAT(assembly::radiation_lines(built.spec, choices),
              ElementsAre("raft: no radiation: of a cause",
                          "high and 1 more: no radiation: it starts dry"));
}

TEST(RadiationChoice, WarnsOfWhatIsWrittenAgainstTheTheory) {
  const std::string second = "  - {name: other, box: {size: [4, 2, 1]}, density: 500,";
  EXPECT_THAT(unsolved(raft() + second + " position: [0, 30, 0]}\n").warnings, IsEmpty());
  const std::string written = " hydro: {radiation: auto}";
  EXPECT_THAT(unsolved(raft(written) + second + " position: [0, 30, 0]}\n").warnings,
              ElementsAre(HasSubstr("raft and other are 30 m apart")));
  EXPECT_THAT(unsolved(raft(written) + second + " position: [0, 41, 0]}\n").warnings, IsEmpty());
  EXPECT_THAT(unsolved(raft(written + ", linear_velocity: [1, 0, 0]")).warnings,
              ElementsAre(HasSubstr("starts with a Froude number of 0.16")));
}

}  // namespace
