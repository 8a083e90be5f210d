#include "app/assembly/radiation_choice.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "app/assembly/build.h"
#include "hydro/lines/catenary.h"
#include "hydro/mesh/mass_properties.h"
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

TEST(RadiationChoice, IsMadeWhereverABodyStartsNearItsRest) {
  EXPECT_EQ(reason(""), "");
  EXPECT_EQ(reason("position: [0, 0, 0.5]"), "");  // It touches the water.
  EXPECT_EQ(reason("position: [0, 0, -0.5]"), "");
  EXPECT_EQ(reason("position: [0, 0, 9], start: equilibrium"), "");
  EXPECT_EQ(reason("orientation: {euler_deg: [40, 0, 0]}"), "");
  EXPECT_EQ(reason("linear_velocity: [3, 0, 0]"), "");
  EXPECT_EQ(reason("lock: [z]"), "");
  const std::string two =
      raft() + "  - {name: other, sphere: {radius: 1}, density: 500, position: [0, 2.1, 0]}\n";
  EXPECT_EQ(choice(two).reason, "");
}

/// Two barges abreast with 2 m of water between them, with more keys of each.
std::string barges_abreast(const std::string& keys) {
  std::string text = "plimsoll: 1\nduration: 1\nwater: {density: 1000}\nbodies:\n";
  for (const int side : {-1, 1})
    text += fmt::format(
        "  - {{name: barge{}, box: {{size: [10, 4, 2.4]}}, density: 500,"
        " position: [0, {}, 0.2]{}}}\n",
        side + 2, 3 * side, keys);
  return text;
}

/// Six spheres of 1 m on a circle of 3 m, each a metre from its neighbours, with more keys of each.
std::string ring_of_spheres(const std::string& keys) {
  std::string text = "plimsoll: 1\nduration: 1\nwater: {density: 1000}\nbodies:\n";
  for (int i = 0; i < 6; ++i)
    text += fmt::format(
        "  - {{name: sphere{}, icosphere: {{radius: 1, subdivisions: 2}}, density: 500,"
        " position: [{}, {}, 0]{}}}\n",
        i, 3 * std::cos(i * M_PI / 3), 3 * std::sin(i * M_PI / 3), keys);
  return text;
}

TEST(RadiationChoice, IsThatOfItsKeyAlsoWhereBodiesFloatSideBySide) {
  for (const auto& scene : {barges_abreast, ring_of_spheres}) {
    const assembly::BuiltScene silent = unsolved(scene(""));
    const assembly::BuiltScene asked = unsolved(scene(", hydro: {radiation: auto}"));
    ASSERT_EQ(silent.radiation.size(), asked.radiation.size());
    for (std::size_t i = 0; i < silent.radiation.size(); ++i) {
      const RadiationChoice& by_default = silent.radiation[i].choice;
      const RadiationChoice& written = asked.radiation[i].choice;
      EXPECT_FALSE(by_default.written);
      EXPECT_TRUE(written.written);
      ASSERT_TRUE(by_default.pose) << by_default.reason;
      ASSERT_TRUE(written.pose) << written.reason;
      EXPECT_EQ(*by_default.pose, *written.pose);
      EXPECT_EQ(by_default.draught, written.draught);
      EXPECT_EQ(by_default.length, written.length);
      EXPECT_EQ(by_default.lead, written.lead);
      EXPECT_EQ(by_default.held, written.held);
      EXPECT_EQ(by_default.simulated, written.simulated);
    }
  }
}

TEST(RadiationChoice, IsNotMadeWhereABodyIsThrownOrDroppedUnlessItIsWritten) {
  EXPECT_THAT(reason("position: [0, 0, 1.1]"), HasSubstr("let go 0.6 m beyond"));
  EXPECT_THAT(reason("position: [0, 0, -9]"), HasSubstr("let go 8.5 m beyond"));
  EXPECT_THAT(reason("linear_velocity: [0, 0, 5]"), HasSubstr("let go 0.775 m beyond"));
  // √(2² + 1² + ½²) m at 2 rad/s: the farthest corner.
  EXPECT_THAT(reason("angular_velocity: [2, 0, 0]"), HasSubstr("let go 0.571 m beyond"));
  EXPECT_EQ(reason("angular_velocity: [0, 0, 9]"), "");
  EXPECT_THAT(reason("orientation: {euler_deg: [0, 46, 0]}"), HasSubstr("it starts 46° from"));
  for (const char* keys : {"position: [0, 0, 1.1]", "orientation: {euler_deg: [0, 46, 0]}"})
    EXPECT_EQ(fault(keys), "") << keys;
  EXPECT_THAT(unsolved(raft("position: [0, 0, 1.1]")).warnings, IsEmpty());
  EXPECT_THAT(
      unsolved(raft("position: [0, 0, -1]")).warnings,
      ElementsAre(HasSubstr("raft: no radiation: it starts as if it were let go 0.5 m beyond")));
}

TEST(RadiationChoice, IsMissedByABodyNearItsRestWhereMethodOrSurfaceHaveNone) {
  const std::pair<std::string, std::string> scenes[] = {
      {"integrator: {method: ode}\n", "integrator.method: ode has no added mass"},
      {"water: {density: 1000, surface: {waves: [{amplitude: 0.1, wavelength: 30}],"
       " kinematics: hydrostatic}}\n",
       "kinematics: hydrostatic has no waves"},
      {"water: {density: 1000, surface: {heightfield: {file: " PLIMSOLL_SOURCE_DIR
       "/scenes/validation/slope.csv, cell: 16, origin: [-32, -32]}}}\n",
       "the water's surface is a fixed height field"}};
  for (const auto& [blocks, why] : scenes) {
    EXPECT_THAT(unsolved(raft("", blocks)).warnings,
                ElementsAre(HasSubstr("raft: no radiation: " + why)));
    // One that is dropped or has asked for none has no waves to miss, and one without buoyancy does
    // not float.
    for (const char* keys :
         {"position: [0, 0, 1.1]", "hydro: {radiation: none}", "hydro: {buoyancy: false}"})
      EXPECT_THAT(unsolved(raft(keys, blocks)).warnings, IsEmpty()) << why << ", " << keys;
    EXPECT_THAT(reason("position: [0, 0, 1.1]", blocks), HasSubstr(why));
  }
}

TEST(RadiationChoice, NeedsOpenWaterOfOneDepthUnlessItIsWritten) {
  EXPECT_EQ(reason("", "ground: {z: -1.9}\n"), "ground is near");
  EXPECT_EQ(reason("", "ground: {z: -2.1}\n"), "");
  EXPECT_EQ(fault("", "ground: {z: -1.9}\n"), "");
  EXPECT_EQ(reason("", "water: {depth: 0.6}\n"), "");
  EXPECT_EQ(reason("", "water: {depth: 1.9}\nground: {z: -1.9}\n"), "");
  EXPECT_EQ(reason("", "water: {depth: 1.9}\nground: {z: -1.8}\n"), "ground is near");
}

/// A flap of 2 m that is hinged 1.5 m below the water and stands out of it by half a metre, turned
/// from there by an angle [deg]. It is lighter than water, and lies flat if nothing holds it.
std::string flap(double angle, const std::string& radiation) {
  const double a = angle * M_PI / 180;
  return fmt::format(
      "plimsoll: 1\nduration: 1\nwater: {{density: 1000}}\nbodies:\n"
      "  - {{name: flap, box: {{size: [0.2, 3, 2]}}, density: 300, position: [{}, 0, {}],"
      " orientation: {{euler_deg: [0, {}, 0]}}, collision: none, hydro: {{{}}}}}\n"
      "joints:\n  - {{type: hinge, name: hinge, bodies: [world, flap], anchor: [0, 0, -1.5],"
      " axis: [0, 1, 0]}}\n",
      std::sin(a), -1.5 + std::cos(a), angle, radiation);
}

TEST(RadiationChoice, IsThePoseThatJointsLeaveToABody) {
  const RadiationChoice c = choice(flap(12, ""));
  ASSERT_TRUE(c.pose) << c.reason;
  EXPECT_NEAR(c.draught, 1.5, 1e-4);
  EXPECT_LT(c.pose->orientation.angularDistance(Eigen::Quaterniond::Identity()), 1e-4);
  EXPECT_EQ(c.held, "the joint hinge");
}

TEST(RadiationChoice, AsksWhichPoseIsMeantWhereAHeldBodyStartsFarFromItsRest) {
  const std::string told = "held by the joint hinge, it comes to rest 20° from its start";
  EXPECT_THAT(choice(flap(20, "")).reason, HasSubstr(told));
  EXPECT_THAT([] { unsolved(flap(20, "radiation: auto")); },
              testing::ThrowsMessage<scene::InputError>(HasSubstr(told)));
  EXPECT_NEAR(choice(flap(20, "radiation: {pose: equilibrium}")).draught, 1.5, 1e-4);
  const RadiationChoice start = choice(flap(20, "radiation: {pose: start}"));
  EXPECT_NEAR(start.pose->orientation.angularDistance(Eigen::Quaterniond::Identity()),
              20 * M_PI / 180, 1e-6);
}

TEST(RadiationChoice, IsThePoseInWhichLinesAndLoadsHoldABody) {
  // A rope that is 0.3 m too short pulls the raft down by as much.
  const RadiationChoice taut =
      choice(raft("", "") +
             "ropes: [{name: line, bodies: [raft, world], points: [[0, 0, 0], [0, 0, -2]],"
             " length: 1.7, stiffness: 1e9}]\n");
  EXPECT_THAT(taut.reason, HasSubstr("held by the line line"));
  const RadiationChoice asked =
      choice(raft("hydro: {radiation: {pose: equilibrium}}", "") +
             "ropes: [{name: line, bodies: [raft, world], points: [[0, 0, 0], [0, 0, -2]],"
             " length: 1.7, stiffness: 1e9}]\n");
  EXPECT_NEAR(asked.draught, 0.8, 1e-4);
  const RadiationChoice loaded =
      choice(raft("forces: [{force: [0, 0, -7845.32]}], hydro: {radiation: {pose: equilibrium}}"));
  EXPECT_NEAR(loaded.draught, 0.6, 1e-4);  // 0.8 m3 more
}

// A spar on a slider, which three moorings hold: upright, and as deep as its weight and the lines'
// pull it.
TEST(RadiationChoice, OfAMooredSparOnASliderIsUpright) {
  const RadiationChoice c = choice(
      "plimsoll: 1\nduration: 1\nwater: {density: 1025, depth: 60}\nbodies:\n"
      "  - {name: spar, cylinder: {radius: 1.2, height: 32, slices: 48}, mass: 110000,\n"
      "     center_of_mass: [0, 0, -10], position: [0, 0, -9], collision: none}\n"
      "  - {name: float, box: {size: [8, 8, 3]}, density: 512, collision: none}\n"
      "joints: [{type: slider, name: pto, bodies: [spar, float], axis: [0, 0, 1]}]\n"
      "moorings:\n"
      "  - {name: a, body: spar, fairlead: [-1, 0, 0], anchor: [-150, 0, -60], length: 160,\n"
      "     weight: 400, stiffness: 1e8}\n"
      "  - {name: b, body: spar, fairlead: [0.5, 0.866025403784, 0], anchor: [75, 129.903810568, "
      "-60],\n     length: 160, weight: 400, stiffness: 1e8}\n"
      "  - {name: c, body: spar, fairlead: [0.5, -0.866025403784, 0], anchor: [75, -129.903810568, "
      "-60],\n     length: 160, weight: 400, stiffness: 1e8}\n");
  ASSERT_TRUE(c.pose) << c.reason;
  const Eigen::Vector3d up = c.pose->orientation * Eigen::Vector3d::UnitZ();
  EXPECT_LT(std::acos(std::min(1.0, up.z())), tolerance(1e-3));
  // Fairleads are 16 m above the foot.
  const hydro::CatenarySolution line =
      hydro::solve_catenary({.length = 160, .weight = 400, .stiffness = 1e8, .friction = 0}, 149,
                            60 - c.draught + 16, true);
  const double area = 48 / 2.0 * 1.2 * 1.2 * std::sin(2 * M_PI / 48);
  EXPECT_NEAR(1025 * area * c.draught / (110000 + 3 * line.vertical / 9.80665), 1, tolerance(1e-4));
}

// Two halves of the raft under a fixed joint have the hull of the whole one.
TEST(RadiationChoice, TakesBodiesUnderFixedJointsAsOneHull) {
  const std::string halves =
      "plimsoll: 1\nduration: 1\nwater: {density: 1000}\nbodies:\n"
      "  - {name: left, box: {size: [2, 2, 1]}, density: 500, position: [-1, 0, 0]}\n"
      "  - {name: right, box: {size: [2, 2, 1]}, density: 500, position: [1, 0, 0]}\n"
      "joints: [{type: fixed, name: weld, bodies: [left, right]}]\n";
  const assembly::BuiltScene built = unsolved(halves);
  const RadiationChoice& left = built.radiation[0].choice;
  ASSERT_TRUE(left.pose) << left.reason;
  EXPECT_NEAR(left.length, 4, 1e-6);
  EXPECT_NEAR(left.draught, 0.5, 1e-6);
  EXPECT_NEAR(hydro::solid_properties(*left.joined_B).volume, 8, 1e-9);
  EXPECT_FALSE(built.radiation[1].choice.pose);
  EXPECT_EQ(built.radiation[1].choice.lead, 0);
  std::string apart = halves;
  apart.replace(apart.find("[1, 0, 0]"), 9, "[0.5, 0, 0]");
  EXPECT_THAT(choice(apart).reason, HasSubstr("left and right, which fixed joints hold together"));
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
  is_told("", "", ", buoyancy: false", "hydro.buoyancy is switched off");
  is_told("", "", ", added_mass: deep", "hydro.added_mass is given");
  is_told("", "water: {density: 400}\n", "", "it sinks");
  is_told("lock: [z], position: [0, 0, 2]", "", "", "it is dry in its mean pose");
  is_told("lock: [z], position: [0, 0, -2]", "", "", "it is submerged in its mean pose");
}

TEST(RadiationChoice, KeepsTheAttitudeOfABodyToWhichItDoesNotMatter) {
  for (const char* shape : {"sphere: {radius: 5}", "icosphere: {radius: 5}"}) {
    const RadiationChoice c =
        choice("plimsoll: 1\nduration: 1\nwater: {}\nbodies:\n  - {name: ball, " +
               std::string(shape) + ", density: 500, orientation: {euler_deg: [40, 30, 0]}}\n");
    ASSERT_TRUE(c.pose) << c.reason;
    EXPECT_NEAR(c.draught, 5, 0.03);  // Of a polyhedron.
  }
}

TEST(RadiationChoice, OfABodyHeldInAllSixIsOnlyMadeByItsKey) {
  EXPECT_EQ(reason("lock: all, position: [0, 0, 0.2]"), "it is held in all six");
  const RadiationChoice c =
      choice(raft("lock: all, position: [0, 0, 0.2], hydro: {radiation: auto}"));
  EXPECT_NEAR(c.draught, 0.3, 1e-6);
}

TEST(RadiationChoice, KeepsWhatIsLocked) {
  // Poses under constraints are rounded to 1e-5 of the radius and of a radian.
  const RadiationChoice held =
      choice(raft("orientation: {euler_deg: [5, 0, 0]}, lock: [roll], hydro: {radiation: auto}"));
  EXPECT_NEAR(held.pose->orientation.angularDistance(Eigen::Quaterniond::Identity()),
              5 * M_PI / 180, tolerance(2e-5));
  EXPECT_NEAR(choice(raft("position: [0, 0, 0.3], lock: [z], hydro: {radiation: auto}")).draught,
              0.2, tolerance(2e-5));
}

TEST(RadiationChoice, IsToldOnceForBodiesThatAreAlike) {
  const assembly::BuiltScene built =
      unsolved(raft() +
               "  - {name: high, sphere: {radius: 1}, density: 500, position: [0, 30, 4]}\n"
               "  - {name: higher, sphere: {radius: 1}, density: 500, position: [0, 60, 4]}\n"
               "  - {name: silent, sphere: {radius: 1}, density: 500, hydro: {radiation: none}}\n");
  std::vector<RadiationChoice> choices;
  for (const assembly::RadiationReport& report : built.radiation) choices.push_back(report.choice);
  choices[0].pose.reset();
  choices[0].reason = "of a cause";
  EXPECT_THAT(
      assembly::radiation_lines(built.spec, choices),
      ElementsAre("raft: no radiation: of a cause",
                  "high and 1 more: no radiation: it starts as if it were let go 3 m beyond where "
                  "it would just touch the surface"));
}

TEST(RadiationChoice, WarnsOfWhatLinearTheoryLeavesOut) {
  const std::string second = "  - {name: other, box: {size: [4, 2, 1]}, density: 500,";
  EXPECT_THAT(unsolved(raft() + second + " position: [0, 30, 0]}\n").warnings, IsEmpty());
  const std::string written = " hydro: {radiation: auto}";
  EXPECT_THAT(unsolved(raft(written) + second + " position: [0, 30, 0]}\n").warnings,
              ElementsAre(HasSubstr("raft: other is 30 m away")));
  EXPECT_THAT(unsolved(raft(written) + second + " position: [0, 41, 0]}\n").warnings, IsEmpty());
}

}  // namespace
