#include "hydro/machines/foil.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::Foil;
using hydro::foil_coefficients;
using hydro::foil_force;
using hydro::FoilCoefficients;
using hydro::Race;

constexpr double kFoilRounding = 1e-13;

Foil foil_of(Foil::Law law) { return {.law = law, .span = 3, .chord = 1.5}; }

/// A symmetric table, to 40°.
Foil tabulated_foil() {
  Foil foil = foil_of(Foil::Law::table);
  foil.table = {{0, 0.2, 0.4, 0.7}, {0, 0.6, 1.0, 0.8}, {0.01, 0.05, 0.2, 0.6}};
  return foil;
}

/// A cambered one, from −10° to 20°.
Foil cambered_foil() {
  Foil foil = foil_of(Foil::Law::table);
  foil.table = {{-0.17, 0, 0.35}, {-0.3, 0.2, 1.2}, {0.03, 0.01, 0.1}};
  return foil;
}

std::vector<Foil> all_foils() {
  return {foil_of(Foil::Law::soding), foil_of(Foil::Law::fujii),
          foil_of(Foil::Law::whicker_fehlner), tabulated_foil(), cambered_foil()};
}

TEST(Foil, HasTheLiftSlopesOfTheLaws) {
  EXPECT_NEAR(hydro::lift_slope(foil_of(Foil::Law::soding)), 2.356, 5e-4);
  EXPECT_NEAR(hydro::lift_slope(foil_of(Foil::Law::fujii)), 2.885, 5e-4);
  EXPECT_NEAR(hydro::lift_slope(foil_of(Foil::Law::whicker_fehlner)), 2.444, 5e-4);
  EXPECT_NEAR(hydro::lift_slope(tabulated_foil()), 3, 1e-6);
  EXPECT_NEAR(hydro::lift_slope(cambered_foil()), 0.5 * (0.5 / 0.17 + 1 / 0.35), 1e-6);
  for (const Foil& foil : all_foils()) {
    const double d = 1e-4;
    const double slope =
        (foil_coefficients(foil, d).lift - foil_coefficients(foil, -d).lift) / (2 * d);
    EXPECT_NEAR(slope, hydro::lift_slope(foil), 1e-6);
  }
}

TEST(Foil, TakesTheEffectiveAspectRatioThatIsGiven) {
  Foil wide = foil_of(Foil::Law::fujii);
  wide.aspect_ratio = 4;
  EXPECT_NEAR(hydro::lift_slope(wide), 6.13 * 4 / 6.25, kFoilRounding);
}

TEST(Foil, LiftsAndDragsAtTenDegreesAsSodingSays) {
  const FoilCoefficients c = foil_coefficients(foil_of(Foil::Law::soding), M_PI / 18);
  EXPECT_NEAR(c.lift, 0.409, 5e-4);
  EXPECT_NEAR(c.drag, 0.01 + 1.1 * c.lift * c.lift / (2 * M_PI), kFoilRounding);
}

TEST(Foil, AcrossTheFlowIsAPlate) {
  for (const Foil& foil : all_foils()) {
    for (const double angle : {-M_PI / 2, M_PI / 2}) {
      const FoilCoefficients c = foil_coefficients(foil, angle);
      EXPECT_NEAR(c.lift, 0, kFoilRounding);
      EXPECT_NEAR(c.drag, 1.2 + 0.01, kFoilRounding);
    }
  }
}

TEST(Foil, IsSymmetricAndIsTheSameFromBehind) {
  for (const Foil& foil : all_foils()) {
    if (foil.table.angle.size() == 3) continue;
    for (double angle = 0; angle < M_PI; angle += 0.01) {
      const FoilCoefficients c = foil_coefficients(foil, angle);
      const FoilCoefficients mirrored = foil_coefficients(foil, -angle);
      EXPECT_NEAR(mirrored.lift, -c.lift, kFoilRounding);
      EXPECT_NEAR(mirrored.drag, c.drag, kFoilRounding);
      if (foil.law == Foil::Law::table) continue;
      const FoilCoefficients behind = foil_coefficients(foil, M_PI - angle);
      EXPECT_NEAR(behind.lift, -c.lift, kFoilRounding);
      EXPECT_NEAR(behind.drag, c.drag, kFoilRounding);
    }
  }
}

TEST(Foil, HasContinuousCoefficientsAtEveryAngle) {
  for (Foil foil : all_foils()) {
    for (const double stall : {0.0, 0.44, 1.3}) {
      foil.stall = stall;
      const int count = 20000;
      FoilCoefficients last = foil_coefficients(foil, M_PI);
      for (int i = 0; i <= count; ++i) {
        const FoilCoefficients c = foil_coefficients(foil, -M_PI + 2 * M_PI * i / count);
        // The steepest is the stall: a fall by 2.5 within 0.2 rad, 1.5 times as steep at its
        // middle.
        ASSERT_LT(std::abs(c.lift - last.lift), 25 * 2 * M_PI / count) << i;
        ASSERT_LT(std::abs(c.drag - last.drag), 25 * 2 * M_PI / count) << i;
        last = c;
      }
    }
  }
}

TEST(Foil, LosesLiftBeyondItsStall) {
  const Foil foil = foil_of(Foil::Law::whicker_fehlner);
  const double before = foil_coefficients(foil, foil.stall).lift;
  EXPECT_NEAR(before, hydro::lift_slope(foil) * std::sin(foil.stall), kFoilRounding);
  const double plate = foil_coefficients(foil, foil.stall + 0.3).lift;
  const double s = std::sin(foil.stall + 0.3);
  EXPECT_NEAR(plate, 1.2 * (4 + M_PI) * s / (4 + M_PI * s) * std::cos(foil.stall + 0.3),
              kFoilRounding);
  EXPECT_LT(plate, before);
}

TEST(Foil, FollowsItsTable) {
  EXPECT_NEAR(foil_coefficients(tabulated_foil(), 0.3).lift, 0.8, kFoilRounding);
  EXPECT_NEAR(foil_coefficients(tabulated_foil(), -0.3).lift, -0.8, kFoilRounding);
  EXPECT_NEAR(foil_coefficients(tabulated_foil(), -0.3).drag, 0.125, kFoilRounding);
  EXPECT_NEAR(foil_coefficients(cambered_foil(), -0.085).lift, -0.05, kFoilRounding);
  EXPECT_NEAR(foil_coefficients(cambered_foil(), 0.35).lift, 1.2, kFoilRounding);
}

TEST(Foil, NeverDoesWork) {
  support::Random random(21);
  for (const Foil& foil : all_foils()) {
    for (int i = 0; i < 5000; ++i) {
      const Eigen::Matrix3d axes = random.rotation().toRotationMatrix();
      const Vector3d flow = random.vector(10);
      const Vector3d force = foil_force(foil, flow, axes.col(0), axes.col(2), 1025);
      ASSERT_GE(force.dot(flow), 0);
      ASSERT_NEAR(force.dot(axes.col(2)), 0, 1e-10 * (1 + force.norm()));
    }
  }
}

TEST(Foil, ForceIsThatOfTheCoefficientsInAnyFrame) {
  support::Random random(22);
  for (const Foil& foil : all_foils()) {
    for (const double angle : {0.2, -0.3, 1.4, 2.5, -3.0}) {
      const Eigen::Matrix3d axes = random.rotation().toRotationMatrix();
      const double speed = 3;
      const FoilCoefficients c = foil_coefficients(foil, angle);
      const double scale = 0.5 * 1000 * 4.5 * speed * speed;
      // Chord along x, span along z: the flow comes from ahead, and to port if the angle is
      // positive.
      const Vector3d flow(-speed * std::cos(angle), speed * std::sin(angle), 1.7);
      const Vector3d along(-std::cos(angle), std::sin(angle), 0);
      const Vector3d lift(std::sin(angle), std::cos(angle), 0);
      const Vector3d expected = scale * (c.drag * along + c.lift * lift);
      const Vector3d force = foil_force(foil, axes * flow, axes.col(0), axes.col(2), 1000);
      EXPECT_LT((force - axes * expected).norm(), support::tolerance(1e-12) * scale);
    }
  }
}

TEST(Foil, ForceIsQuadraticAndVanishesWithTheFlow) {
  const Foil foil;
  const Vector3d flow(-1, 0.3, 0.2);
  const auto force = [&](double factor) {
    return foil_force(foil, factor * flow, Vector3d::UnitX(), Vector3d::UnitZ(), 1000);
  };
  EXPECT_EQ(force(0), Vector3d::Zero());
  EXPECT_LT((force(1e-3) - 1e-6 * force(1)).norm(), 1e-15 * force(1).norm());
}

TEST(Foil, RefusesFieldsOutOfRange) {
  const auto refuses = [](Foil foil, const std::string& what) {
    try {
      hydro::check_foil(foil);
      ADD_FAILURE() << "expected a refusal of the " << what;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  for (const Foil& foil : all_foils()) EXPECT_NO_THROW(hydro::check_foil(foil));
  refuses({.span = 0}, "span of a foil is 0.000000");
  refuses({.chord = -1}, "chord");
  refuses({.aspect_ratio = -1}, "aspect ratio");
  refuses({.drag_zero = -0.1}, "drag coefficient");
  refuses({.stall = 1.5}, "stall angle");
  refuses({.stall = std::nan("")}, "stall angle");
  refuses({.law = Foil::Law::table}, "number of table rows");
  refuses({.law = Foil::Law::table, .table = {{0, 1}, {0}, {0, 0}}}, "length of a table column");
  refuses({.law = Foil::Law::table, .table = {{0, 4}, {0, 1}, {0, 0}}}, "table angle");
  refuses({.law = Foil::Law::table, .table = {{1, 0}, {0, 1}, {0, 0}}}, "table angle");
  refuses({.law = Foil::Law::table, .table = {{0, 1}, {0, 1}, {0, -1}}}, "drag coefficient");
}

TEST(PropellerRace, IsThatOfMomentumTheoryInTheDiscAndFarBehind) {
  const double inflow = 2, thrust = 30000, diameter = 2, density = 1025;
  const double far = std::sqrt(4 + 2 * thrust / (density * M_PI));
  const double disc = 0.5 * (inflow + far);
  const Race at_disc = hydro::propeller_race(inflow, thrust, diameter, 0, density);
  EXPECT_NEAR(at_disc.speed, disc, kFoilRounding);
  EXPECT_NEAR(at_disc.diameter, diameter, kFoilRounding);
  const Race behind = hydro::propeller_race(inflow, thrust, diameter, 1e12, density);
  EXPECT_NEAR(behind.speed, far, 1e-10);
  EXPECT_NEAR(behind.diameter, diameter * std::sqrt(disc / far), 1e-10);
  // Thrust is the growth of the momentum far behind.
  const double flow = density * M_PI / 4 * behind.diameter * behind.diameter * behind.speed;
  EXPECT_NEAR(flow * (behind.speed - inflow), thrust, support::tolerance(1e-6) * thrust);
}

TEST(PropellerRace, KeepsItsVolumeFlowAtEveryDistance) {
  const double flow = hydro::propeller_race(2, 1e4, 1.5, 0, 1000).speed * 1.5 * 1.5;
  for (const double distance : {-0.3, 0.1, 1.0, 20.0}) {
    const Race race = hydro::propeller_race(2, 1e4, 1.5, distance, 1000);
    EXPECT_NEAR(race.speed * race.diameter * race.diameter, flow, 1e-12 * flow);
  }
  const double share = 0.5 + 0.5 / (1 + 0.15 * 1.5 / 1.0);
  const double far = std::sqrt(4 + 2e4 / (1000 * M_PI * 1.5 * 1.5 / 4));
  EXPECT_NEAR(hydro::propeller_race(2, 1e4, 1.5, 1, 1000).speed, 2 + share * (far - 2),
              kFoilRounding);
}

TEST(PropellerRace, IsTheUndisturbedFlowWithoutThrustAndHasNoJump) {
  for (const double inflow : {-3.0, 0.0, 3.0}) {
    for (const double thrust : {0.0, -1e4}) {
      const Race race = hydro::propeller_race(inflow, thrust, 2, 1, 1000);
      EXPECT_EQ(race.speed, inflow);
      EXPECT_EQ(race.diameter, 2);
    }
    EXPECT_NEAR(hydro::propeller_race(inflow, 1e-9, 2, 1, 1000).speed, inflow, 1e-5);
  }
  const Race from_ahead = hydro::propeller_race(1e-9, 1e4, 2, 1, 1000);
  const Race from_behind = hydro::propeller_race(-1e-9, 1e4, 2, 1, 1000);
  EXPECT_NEAR(from_ahead.speed, from_behind.speed, 1e-8);
  EXPECT_NEAR(from_ahead.diameter, from_behind.diameter, 1e-8);
}

}  // namespace
