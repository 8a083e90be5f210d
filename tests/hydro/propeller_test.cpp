#include "hydro/machines/propeller.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "hydro/machines/wageningen.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::FourQuadrantTable;
using hydro::OpenWater;
using hydro::OpenWaterTable;
using hydro::Propeller;
using hydro::PropellerCurves;
using hydro::PropellerLoad;
using hydro::PropellerModel;
using hydro::QuadrantCoefficients;
using hydro::WageningenB;

constexpr double kPropellerRounding = 1e-13;

/// K_T and K_Q of B4-70, as a table that ends before the thrust is zero.
OpenWaterTable coarse_table() {
  OpenWaterTable table;
  for (double j = 0; j < 0.95; j += 0.1) {
    const OpenWater k = hydro::open_water({}, j);
    table.advance_ratio.push_back(j);
    table.thrust_coefficient.push_back(k.thrust_coefficient);
    table.torque_coefficient.push_back(k.torque_coefficient);
  }
  return table;
}

FourQuadrantTable four_quadrants() {
  return {{-2.5, -1, 0, 0.5, 1.5, 3},
          {0.1, 0.8, 0.24, 0, -0.7, -0.2},
          {0, 0.1, 0.04, 0.01, -0.1, -0.03}};
}

std::vector<WageningenB> whole_series() {
  std::vector<WageningenB> screws;
  for (int blades = 2; blades <= 7; ++blades)
    for (const double area : {0.3, 0.55, 0.8, 1.05})
      for (const double pitch : {0.5, 0.8, 1.1, 1.4}) screws.push_back({blades, area, pitch});
  return screws;
}

TEST(WageningenB, HasTheValuesOfAnIndependentEvaluation) {
  struct Row {
    WageningenB screw;
    std::array<double, 3> thrust, torque;  ///< K_T and 10 K_Q at J = 0, 0.4, 0.8.
  };
  const std::array<Row, 4> rows = {{
      {{4, 0.70, 1.0}, {0.45474, 0.31425, 0.12973}, {0.67538, 0.49210, 0.23973}},
      {{4, 0.55, 1.0}, {0.42425, 0.30380, 0.13555}, {0.61290, 0.46552, 0.24773}},
      {{3, 0.50, 0.8}, {0.32169, 0.19585, 0.03467}, {0.38785, 0.25524, 0.07849}},
      {{5, 0.75, 1.2}, {0.55871, 0.43060, 0.24654}, {0.97623, 0.77594, 0.48567}},
  }};
  for (const Row& row : rows) {
    for (int i = 0; i < 3; ++i) {
      const OpenWater k = hydro::open_water(row.screw, 0.4 * i);
      EXPECT_NEAR(k.thrust_coefficient, row.thrust[i], support::tolerance(5.1e-6));
      EXPECT_NEAR(10 * k.torque_coefficient, row.torque[i], support::tolerance(5.1e-6));
    }
  }
}

TEST(WageningenB, RefusesScrewsOutsideTheSeries) {
  EXPECT_THROW(hydro::open_water({8, 0.7, 1}, 0), std::invalid_argument);
  EXPECT_THROW(hydro::open_water({4, 1.2, 1}, 0), std::invalid_argument);
  EXPECT_THROW(hydro::open_water({4, 0.7, 0.4}, 0), std::invalid_argument);
  EXPECT_THROW(hydro::open_water({4, std::nan(""), 1}, 0), std::invalid_argument);
}

TEST(Propeller, PullsAtTheBollardAsTheSeriesSays) {
  const PropellerCurves curves({.model = WageningenB{}, .diameter = 2});
  const PropellerLoad load = curves.load(3, 0, 1025, 1);
  EXPECT_NEAR(load.thrust, 67120, support::tolerance(5));
  EXPECT_NEAR(load.torque, 19940, support::tolerance(5));
  const PropellerLoad astern = curves.load(-3, 0, 1025, 1);
  EXPECT_NEAR(astern.thrust, -0.7 * load.thrust, kPropellerRounding * load.thrust);
  EXPECT_NEAR(astern.torque, -0.7 * load.torque, kPropellerRounding * load.torque);
}

TEST(Propeller, HasTheThrustAndTorqueOfOpenWaterInTheFirstQuadrant) {
  for (const WageningenB& screw : whole_series()) {
    const PropellerCurves curves({.model = screw, .diameter = 1.7});
    for (double j = 0; j < 2; j += 0.05) {
      const OpenWater k = hydro::open_water(screw, j);
      if (k.thrust_coefficient < 0) break;
      const double n = 2.3;
      const PropellerLoad load = curves.load(n, j * n * 1.7, 1000, 1);
      const double scale = 1000 * n * n * std::pow(1.7, 4);
      EXPECT_NEAR(load.thrust, scale * k.thrust_coefficient,
                  support::tolerance(kPropellerRounding) * scale);
      EXPECT_NEAR(load.torque, scale * 1.7 * k.torque_coefficient,
                  support::tolerance(kPropellerRounding) * scale);
      EXPECT_NEAR(load.advance_ratio, j, kPropellerRounding);
    }
  }
}

TEST(Propeller, FollowsATableAndGoesOnToZeroThrust) {
  const OpenWaterTable table = coarse_table();
  const PropellerCurves curves({.model = table});
  for (std::size_t i = 0; i < table.advance_ratio.size(); ++i) {
    const PropellerLoad load = curves.load(1, table.advance_ratio[i], 1, 1);
    EXPECT_NEAR(load.thrust, table.thrust_coefficient[i], kPropellerRounding);
    EXPECT_NEAR(load.torque, table.torque_coefficient[i], kPropellerRounding);
  }
  const double middle = 0.5 * (table.thrust_coefficient[3] + table.thrust_coefficient[4]);
  EXPECT_NEAR(curves.load(1, 0.35, 1, 1).thrust, middle, kPropellerRounding);
  const double slope = 10 * (table.thrust_coefficient[9] - table.thrust_coefficient[8]);
  EXPECT_NEAR(curves.load(1, 0.93, 1, 1).thrust, table.thrust_coefficient[9] + 0.03 * slope,
              kPropellerRounding);
}

TEST(Propeller, UsesTheRowsOfATableOnBothSidesOfTheFirstQuadrant) {
  const OpenWaterTable table{{-0.4, 0, 0.8, 1.2}, {0.5, 0.4, 0, -0.3}, {0.07, 0.05, 0.01, -0.02}};
  const PropellerCurves curves({.model = table});
  EXPECT_NEAR(curves.load(1, -0.3, 1, 1).thrust, 0.475, kPropellerRounding);
  EXPECT_NEAR(curves.load(1, 1.1, 1, 1).thrust, -0.225, kPropellerRounding);
  EXPECT_NEAR(curves.load(1, 1.1, 1, 1).torque, -0.0125, kPropellerRounding);
}

TEST(Propeller, HasTheRowsOfATableOfFourQuadrantsAndRepeatsAfterATurn) {
  const FourQuadrantTable table = four_quadrants();
  const PropellerCurves curves({.model = table});
  for (std::size_t i = 0; i < table.beta.size(); ++i) {
    EXPECT_NEAR(curves.coefficients(table.beta[i]).thrust, table.thrust[i], kPropellerRounding);
    EXPECT_NEAR(curves.coefficients(table.beta[i]).torque, table.torque[i], kPropellerRounding);
  }
  EXPECT_NEAR(curves.coefficients(0.25).thrust, 0.12, kPropellerRounding);
  const double turn = (M_PI - 3) / (2 * M_PI - 5.5);
  for (const double beta : {-M_PI, M_PI})
    EXPECT_NEAR(curves.coefficients(beta).thrust, -0.2 + 0.3 * turn, kPropellerRounding);
}

TEST(Propeller, HasContinuousCurvesOverTheWholeCircle) {
  std::vector<PropellerModel> models = {coarse_table(), four_quadrants()};
  for (const WageningenB& screw : whole_series()) models.emplace_back(screw);
  for (const PropellerModel& model : models) {
    const PropellerCurves curves({.model = model});
    const int count = 20000;
    QuadrantCoefficients last = curves.coefficients(M_PI);
    for (int i = 0; i <= count; ++i) {
      const QuadrantCoefficients c = curves.coefficients(-M_PI + 2 * M_PI * i / count);
      // No slope is above 10 per rad.
      ASSERT_LT(std::abs(c.thrust - last.thrust), 10 * 2 * M_PI / count);
      ASSERT_LT(std::abs(c.torque - last.torque), 10 * 2 * M_PI / count);
      last = c;
    }
  }
}

TEST(Propeller, TakesNoEnergyFromWaterAtRest) {
  std::vector<PropellerModel> models = {coarse_table()};
  for (const WageningenB& screw : whole_series()) models.emplace_back(screw);
  for (const PropellerModel& model : models) {
    const PropellerCurves curves({.model = model, .diameter = 2});
    for (int i = 0; i < 2000; ++i) {
      const double beta = 2 * M_PI * i / 2000;
      const double n = std::cos(beta) / (0.7 * M_PI * 2), speed = std::sin(beta);
      const PropellerLoad load = curves.load(n, speed, 1000, 1);
      const double shaft = 2 * M_PI * n * load.torque;
      ASSERT_GE(shaft - load.open_thrust * load.inflow, -1e-10) << "beta " << beta;
    }
  }
}

TEST(Propeller, StoppedOpposesTheFlowAndWindmillsInIt) {
  for (const WageningenB& screw : whole_series()) {
    const PropellerCurves curves({.model = screw, .diameter = 1.5, .reverse = 0.6});
    const PropellerLoad ahead = curves.load(0, 2, 1000, 1);
    EXPECT_LT(ahead.thrust, -0.2 * screw.area_ratio * 2000 * 1.767);
    EXPECT_LT(ahead.torque, 0);
    EXPECT_NEAR(curves.load(0, -2, 1000, 1).thrust, -ahead.thrust, 1e-9);
    EXPECT_NEAR(curves.load(0, 6, 1000, 1).thrust, 9 * ahead.thrust, 1e-8);
    // The same from either side of n = 0.
    for (const double n : {-1e-9, 1e-9})
      EXPECT_NEAR(curves.load(n, 2, 1000, 1).thrust, ahead.thrust, 1e-5);
    EXPECT_EQ(curves.load(0, 0, 1000, 1).thrust, 0);
    EXPECT_EQ(curves.load(0, 0, 1000, 1).torque, 0);
  }
}

TEST(Propeller, BehindAHullTakesWakeDeductionAndRotativeEfficiency) {
  const PropellerCurves open({.model = WageningenB{}, .diameter = 2});
  const PropellerCurves behind({.model = WageningenB{},
                                .diameter = 2,
                                .wake = 0.25,
                                .deduction = 0.1,
                                .rotative_efficiency = 1.05});
  const PropellerLoad a = open.load(2, 3, 1025, 1);
  const PropellerLoad b = behind.load(2, 4, 1025, 0.5);
  EXPECT_NEAR(b.inflow, 3, kPropellerRounding);
  EXPECT_NEAR(b.open_thrust, 0.5 * a.thrust, 1e-9);
  EXPECT_NEAR(b.thrust, 0.45 * a.thrust, 1e-9);
  EXPECT_NEAR(b.torque, 0.5 * a.torque / 1.05, 1e-9);
}

TEST(Propeller, RefusesParametersOutOfRange) {
  const auto refuses = [](const Propeller& propeller, const std::string& what) {
    try {
      const PropellerCurves curves(propeller);
      ADD_FAILURE() << "expected a refusal of the " << what;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  refuses({.model = WageningenB{}, .diameter = 0}, "diameter of a propeller is 0.000000");
  refuses({.model = WageningenB{}, .wake = 1}, "wake fraction");
  refuses({.model = WageningenB{}, .deduction = 1.2}, "thrust deduction");
  refuses({.model = WageningenB{}, .rotative_efficiency = 0}, "rotative efficiency");
  refuses({.model = WageningenB{}, .reverse = -1}, "thrust astern");
  refuses({.model = WageningenB{.blades = 1}}, "number of blades");
  refuses({.model = OpenWaterTable{{0}, {1}, {1}}}, "number of table rows");
  refuses({.model = OpenWaterTable{{0, 1}, {1, 0}, {1}}}, "length of a table column");
  refuses({.model = OpenWaterTable{{0.1, 1}, {1, 0}, {1, 0}}}, "first advance ratio");
  refuses({.model = OpenWaterTable{{0, 1, 1}, {1, 0, 0}, {1, 0, 0}}}, "advance ratio");
  refuses({.model = OpenWaterTable{{0, 1}, {0.5, 0.6}, {1, 0}}}, "last slope");
  refuses({.model = OpenWaterTable{{0, 1}, {-0.5, -0.6}, {1, 0}}}, "thrust coefficient at J = 0");
  refuses({.model = FourQuadrantTable{{-4, 1}, {0, 0}, {0, 0}}}, "angle beta");
  refuses({.model = FourQuadrantTable{{-M_PI, M_PI}, {0, 1}, {0, 0}}}, "last thrust");
}

/// Share of points below the surface, on rings and spokes of the disc.
double counted_share(const Vector3d& center, const Vector3d& axis, double diameter, double height) {
  const Vector3d across = axis.unitOrthogonal();
  const Vector3d other = axis.cross(across);
  const int rings = 200, spokes = 400;
  int below = 0;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < spokes; ++j) {
      const double r = 0.5 * diameter * std::sqrt((i + 0.5) / rings);
      const double a = 2 * M_PI * (j + 0.5) / spokes;
      const Vector3d p = center + r * (std::cos(a) * across + std::sin(a) * other);
      below += p.z() < height;
    }
  }
  return static_cast<double>(below) / (rings * spokes);
}

TEST(WettedShare, AgreesWithACountOfPointsAtAnyTilt) {
  support::Random random(11);
  for (int i = 0; i < 40; ++i) {
    const Vector3d axis = random.rotation() * Vector3d::UnitX();
    const Vector3d center = random.vector(0.5);
    EXPECT_NEAR(hydro::wetted_share(center, axis, 1.3, 0.1), counted_share(center, axis, 1.3, 0.1),
                support::tolerance(4e-3));  // the ring that the surface cuts
  }
}

TEST(WettedShare, GoesFromNoneToAllWithoutAJump) {
  for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0.6, 0, 0.8), Vector3d(0, 0, 1)}) {
    EXPECT_EQ(hydro::wetted_share({0, 0, 2}, axis, 2, 0.5), 0);
    EXPECT_EQ(hydro::wetted_share({0, 0, -2}, axis, 2, 0.5), 1);
    EXPECT_EQ(hydro::wetted_share({3, 4, 0.5}, axis, 2, 0.5), 0.5);
    double last = 1;
    for (double z = -1.5; z < 1.5; z += 1e-3) {
      const double share = hydro::wetted_share({0, 0, z}, axis, 2, 0);
      EXPECT_LE(share, last);
      EXPECT_LT(last - share, 0.02);
      last = share;
    }
  }
}

}  // namespace
