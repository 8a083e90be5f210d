#include "hydro/resistance/resistance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::BodyState;
using hydro::Resistance;
using hydro::ResistanceCurve;
using hydro::Vector6d;
using support::tolerance;

/// With a hump and a hollow.
ResistanceCurve humped() { return {{0.5, 1, 1.4, 2, 3}, {1, 10, 8, 30, 35}}; }

TEST(ResistanceCurve, GoesThroughItsPointsAndTheOrigin) {
  const ResistanceCurve curve = humped();
  ASSERT_EQ(curve.speeds().size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(curve.at(curve.speeds()[i]), curve.forces()[i], tolerance(1e-12));
  EXPECT_EQ(curve.at(0), 0);
  EXPECT_EQ(curve.slope(0), 0);
}

TEST(ResistanceCurve, IsThatOfSquaresAndGoesOnAsASquare) {
  const ResistanceCurve square({1, 2, 4}, {3, 12, 48});
  for (const double speed : {0.1, 0.9, 1.5, 3.0, 5.0, 40.0}) {
    EXPECT_NEAR(square.at(speed), 3 * speed * speed, tolerance(1e-11) * speed * speed);
    EXPECT_NEAR(square.slope(speed), 6 * speed, tolerance(1e-11) * speed);
  }
  EXPECT_NEAR(humped().at(6), 4 * 35, tolerance(1e-11));
  const ResistanceCurve one({2}, {8});
  EXPECT_NEAR(one.at(1), 2, tolerance(1e-12));
}

TEST(ResistanceCurve, IsSmoothAndMonotoneBetweenPoints) {
  const ResistanceCurve curve = humped();
  const double h = 1e-6;
  for (double speed = 0.01; speed < 2.999; speed += 0.0137) {
    EXPECT_NEAR(curve.slope(speed), (curve.at(speed + h) - curve.at(speed - h)) / (2 * h),
                tolerance(2e-4));
    EXPECT_NEAR(curve.slope(speed + 1e-9), curve.slope(speed), tolerance(1e-5));
  }
  // Slopes at a hump and a hollow may be other than 0.
  for (double speed = 2; speed < 3; speed += 0.01) EXPECT_GE(curve.slope(speed), 0);
  for (double speed = 0; speed < 0.5; speed += 0.01) EXPECT_GE(curve.slope(speed), 0);
}

TEST(ResistanceCurve, IsNowhereNegative) {
  const ResistanceCurve curve({1, 2, 3, 4, 5}, {5, 0, 1, 0, 9});
  for (double speed = 0; speed < 6; speed += 0.001) EXPECT_GE(curve.at(speed), 0) << speed;
}

Resistance some_resistance() { return {.curve = humped(), .at_B = {0.3, -0.1, -0.4}, .volume = 2}; }

Resistance with_suction() {
  Resistance resistance = some_resistance();
  resistance.suction = 7;
  resistance.suction_at_B = {-0.2, 0.1, -0.3};
  return resistance;
}

BodyState some_state(const Vector3d& velocity, const Vector3d& spin) {
  BodyState state = support::Random(3).state(1, 1);
  state.linear_velocity = velocity;
  state.angular_velocity = spin;
  return state;
}

TEST(Resistance, ActsAgainstTheMotionInTheWater) {
  const Resistance resistance = some_resistance();
  const BodyState state = some_state({2, 1.5, -4}, Vector3d::Zero());
  const hydro::Wrench load = hydro::resistance_load(resistance, state, {-1, 1.5, 7}, 2);
  const Vector3d force(-resistance.curve.at(3), 0, 0);
  EXPECT_LT((load.force - force).norm(), tolerance(1e-12));
  const Vector3d arm = state.orientation * resistance.at_B;
  EXPECT_LT((load.moment - arm.cross(force)).norm(), tolerance(1e-12));
  const hydro::Wrench none = hydro::resistance_load(resistance, state, {2, 1.5, 0}, 2);
  EXPECT_TRUE(none.force.isZero(0));
}

TEST(Resistance, FadesWithTheSecondHalfOfTheVolume) {
  const BodyState state = some_state({2, 1, 0}, {0.1, 0.2, 0.3});
  const auto force = [&](double volume) {
    return hydro::resistance_load(some_resistance(), state, Vector3d::Zero(), volume).force.norm();
  };
  EXPECT_EQ(force(1), force(2));
  EXPECT_EQ(force(9), force(2));
  EXPECT_NEAR(force(0.25), force(2) / 4, tolerance(1e-12));
  EXPECT_EQ(force(0), 0);
}

TEST(Resistance, DrawsABodyDownWithTheSquareOfItsSpeed) {
  const BodyState state = some_state({2, 0, 0}, Vector3d::Zero());
  const hydro::Wrench without = hydro::resistance_load(some_resistance(), state, {-1, 0, 0}, 2);
  const hydro::Wrench with = hydro::resistance_load(with_suction(), state, {-1, 0, 0}, 2);
  const Vector3d down(0, 0, -7 * 9);
  EXPECT_LT((with.force - without.force - down).norm(), tolerance(1e-12));
  const Vector3d arm = state.orientation * with_suction().suction_at_B;
  EXPECT_LT((with.moment - without.moment - arm.cross(down)).norm(), tolerance(1e-12));
}

TEST(Resistance, GivesNoEnergyToAnyMotion) {
  for (int i = 0; i < 200; ++i) {
    const Vector3d v = 2 * Vector3d(std::sin(i), std::cos(3 * i), std::sin(7 * i));
    const Vector3d spin = 3 * Vector3d(std::cos(2 * i), std::sin(5 * i), std::cos(11 * i));
    const BodyState state = some_state(v, spin);
    const hydro::Wrench load =
        hydro::resistance_load(some_resistance(), state, Vector3d::Zero(), 0.01 * i);
    const double power = load.force.dot(v) + load.moment.dot(spin);
    EXPECT_LE(power, tolerance(1e-12));
    const hydro::Wrench more =
        hydro::resistance_load(with_suction(), state, Vector3d::Zero(), 0.01 * i);
    EXPECT_NEAR(more.force.dot(v) + more.moment.dot(spin), power, tolerance(1e-10));
  }
}

TEST(Resistance, HasTheJacobianOfItsLoad) {
  Resistance resistance = some_resistance();
  resistance.curve = {{1, 2}, {3, 12}};
  const Vector3d water(0.5, 0.2, 0);
  Vector6d u;
  u << 1.3, -0.7, 0.4, 0.3, -0.2, 0.5;
  const auto load = [&](const Vector6d& at) {
    const hydro::Wrench w =
        hydro::resistance_load(resistance, some_state(at.head<3>(), at.tail<3>()), water, 0.8);
    Vector6d all;
    all << w.force, w.moment;
    return all;
  };
  const BodyState state = some_state(u.head<3>(), u.tail<3>());
  const hydro::Matrix6d J = hydro::resistance_jacobian(resistance, state, water, 0.8);
  EXPECT_LT((J - J.transpose()).norm(), tolerance(1e-12));
  for (int i = 0; i < 6; ++i) {
    const Vector6d step = 1e-5 * Vector6d::Unit(i);
    const Vector6d column = (load(u + step) - load(u - step)) / 2e-5;
    EXPECT_LT((J.col(i) - column).norm(), tolerance(1e-6)) << i;
  }
  EXPECT_TRUE(hydro::resistance_jacobian(resistance, state, state.linear_velocity, 0).isZero(0));
}

}  // namespace
