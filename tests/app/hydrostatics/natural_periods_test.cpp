#include "app/hydrostatics/natural_periods.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "tests/app/program/program.h"
#include "tests/app/scene_text.h"
#include "tests/support/tolerance.h"

namespace {

using nlohmann::json;
using std::numbers::pi;
using testing::HasSubstr;

/// A barge of 20 × 8 × 4 m that draws 2 m, KG = 1.5 m, with gyradii of 3, 5 and 5 m and its added
/// mass given.
const std::string kPlainBarge =
    "plimsoll: 1\nduration: 1\ngravity: 10\nwater: {density: 1000}\n"
    "bodies:\n"
    "  - name: barge\n"
    "    box: {size: [20, 8, 4]}\n"
    "    mass: 320000\n"
    "    center_of_mass: [0, 0, -0.5]\n"
    "    gyration: [3, 5, 5]\n"
    "    orientation: {euler_deg: [0, 0, 30]}\n"
    "    start: equilibrium\n"
    "    hydro: {added_mass: {matrix: [[4e4, 0, 0, 0, 0, 0], [0, 1e5, 0, 0, 0, 0],"
    " [0, 0, 5e5, 0, 0, 0],\n"
    "      [0, 0, 0, 1e6, 0, 0], [0, 0, 0, 0, 6e6, 0], [0, 0, 0, 0, 0, 1e6]]}}\n";

json natural_periods(const std::string& scene) {
  const std::string text =
      support::output_of({"hydrostatics", support::write_scene(scene), "--json"});
  return json::parse(text)["bodies"]["barge"]["natural_periods"];
}

double period_of(const json& periods, const std::string& motion) {
  for (const json& mode : periods["modes"])
    if (mode["motion"] == motion) return mode["period"];
  ADD_FAILURE() << motion << " in " << periods;
  return 0;
}

/// Sums of some hundred terms, and the equilibrium of the start.
const double kRelative = support::tolerance(1e-9);

void expect_period(const json& periods, const std::string& motion, double stiffness,
                   double inertia) {
  EXPECT_NEAR(period_of(periods, motion) / (2 * pi * std::sqrt(inertia / stiffness)), 1, kRelative)
      << motion;
}

constexpr double kMass = 320000, kWeight = kMass * 10;

TEST(NaturalPeriods, OfABargeWithAGivenAddedMassAreItsClosedForms) {
  const json periods = natural_periods(kPlainBarge);
  ASSERT_EQ(periods["modes"].size(), 3);
  expect_period(periods, "heave", 1000 * 10 * 160.0, kMass + 5e5);
  expect_period(periods, "roll", kWeight * (1 + 8 / 3.0 - 1.5), 9 * kMass + 1e6);
  expect_period(periods, "pitch", kWeight * (1 + 50 / 3.0 - 1.5), 25 * kMass + 6e6);
  EXPECT_EQ(periods["added_mass"], "the scene's matrix of added mass");
  EXPECT_EQ(periods["left_out"], json::array());
}

TEST(NaturalPeriods, OfAMooredBargeHaveItsSurge) {
  // Two springs along the barge's heading of 30° through its centre of mass, 0.5 m under the water.
  const double c = std::cos(pi / 6), s = std::sin(pi / 6);
  std::ostringstream springs;
  springs.precision(17);
  springs << "springs:\n";
  for (const int side : {1, -1})
    springs << "  - {name: s" << (side + 1) << ", bodies: [barge, world], points: [[" << side * 10
            << ", 0, -0.5], [" << side * 60 * c << ", " << side * 60 * s
            << ", -0.5]], stiffness: 1000, damping: 0, length: 50}\n";
  const json periods = natural_periods(kPlainBarge + springs.str());
  ASSERT_EQ(periods["modes"].size(), 4);
  expect_period(periods, "surge", 2000, kMass + 4e4);
  expect_period(periods, "heave", 1000 * 10 * 160.0, kMass + 5e5);
  EXPECT_NEAR(periods["modes"][0]["shape"][0], 1, kRelative) << "of the longest period";
  EXPECT_NEAR(periods["modes"][0]["shape"][1], 0, kRelative) << "along the barge";
}

TEST(NaturalPeriods, TellWhereTheyAreNotKnown) {
  const std::string jointed =
      kPlainBarge + "joints:\n  - {type: ball, bodies: [barge, world], anchor: [0, 0, -2]}\n";
  EXPECT_THAT(natural_periods(jointed)["missing"].get<std::string>(), HasSubstr("has a joint"));
  EXPECT_THAT(support::output_of({"hydrostatics", support::write_scene(kPlainBarge)}),
              HasSubstr("\n  natural periods: roll 4.7 s, heave 4.498 s, pitch 3.269 s\n"));
  EXPECT_THAT(support::output_of({"hydrostatics", support::write_scene(kPlainBarge), "--csv"}),
              HasSubstr("barge,rest,natural_period_heave,,"));
}

TEST(NaturalPeriods, OfABodyThatCapsizesHaveNoRoll) {
  hydro::LinearBody body{.inertia = hydro::Matrix6d::Identity()};
  body.stiffness.diagonal() << 0, 0, 4, -1, 9, 0;
  const app::NaturalPeriods periods = app::natural_periods(body, 0, nullptr);
  ASSERT_EQ(periods.modes.size(), 2);
  EXPECT_EQ(periods.modes[0].name(" + "), "heave");
  EXPECT_NEAR(periods.modes[1].period, 2 * pi / 3, 1e-14);
  body.stiffness.setZero();
  EXPECT_THAT(app::natural_periods_text(app::natural_periods(body, 0, nullptr)),
              HasSubstr("none, as nothing restores"));
}

TEST(NaturalPeriods, NameAModeByTheMotionsThatHoldItsEnergy) {
  // Heave and pitch of equal frequencies, coupled: half of the energy is in each.
  hydro::LinearBody body{.inertia = hydro::Matrix6d::Identity()};
  body.stiffness.diagonal() << 0, 0, 4, 1, 4, 0;
  body.stiffness(2, 4) = body.stiffness(4, 2) = 1;
  const app::NaturalPeriods periods = app::natural_periods(body, 0, nullptr);
  ASSERT_EQ(periods.modes.size(), 3);
  EXPECT_EQ(periods.modes[0].name("_"), "roll");
  for (const int i : {1, 2}) {
    EXPECT_EQ(periods.modes[i].motions.size(), 2);
    EXPECT_NEAR(std::abs(periods.modes[i].shape[2]), 1, 1e-12);
    EXPECT_NEAR(periods.modes[i].shape[2] * periods.modes[i].shape[4], i == 1 ? -1 : 1, 1e-12);
  }
}

}  // namespace
