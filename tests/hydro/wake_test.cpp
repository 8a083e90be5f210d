#include "hydro/loads/wake.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/mesh/primitives.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using hydro::advanced_wake;
using hydro::formed_wake;
using hydro::Vector6d;
using hydro::wake_scale;
using hydro::WakeScale;
using support::tolerance;

const Matrix3d kUpright = Matrix3d::Identity();

Vector6d six(const Vector3d& v, const Vector3d& w = Vector3d::Zero()) {
  Vector6d u;
  u << v, w;
  return u;
}

/// f of a body of the size 1 m that has gone a straight way from rest.
double formed_after(double way) {
  const WakeScale scale = wake_scale(hydro::make_icosphere(0.5, 3));
  const double diameter = scale.length / hydro::kWakeLength;
  const Vector6d d =
      advanced_wake(scale, kUpright, Vector6d::Zero(), six({0.3, 0.4, 0}), way * diameter / 0.5);
  return formed_wake(scale, kUpright, d);
}

/// The power that u |u| f u takes in long-lasting swings, over that with f = 1.
double share_in_swings(double keulegan_carpenter) {
  const WakeScale scale = wake_scale(hydro::make_box(Vector3d::Ones()));
  const double amplitude = keulegan_carpenter / (2 * M_PI);
  constexpr int kSteps = 2000, kPeriods = 12;
  double taken = 0, whole = 0;
  Vector6d d = Vector6d::Zero();
  for (int i = 0; i < kPeriods * kSteps; ++i) {
    const double u = amplitude * std::cos(2 * M_PI * (i + 0.5) / kSteps);
    const Vector6d next = advanced_wake(scale, kUpright, d, six({0, u, 0}), 2 * M_PI / kSteps);
    const double power = std::pow(std::abs(u), 3);
    if (i >= (kPeriods - 1) * kSteps) {
      taken += power * formed_wake(scale, kUpright, (d + next) / 2);
      whole += power;
    }
    d = next;
  }
  return taken / whole;
}

TEST(Wake, FormsWithinSomeDiametersFromRest) {
  EXPECT_NEAR(formed_after(0), 0, 0);
  for (const double way : {0.5, 1.0, 2.0, 3.0})
    EXPECT_NEAR(formed_after(way), std::pow(1 - std::exp(-way / 0.6), 4), tolerance(1e-12)) << way;
}

TEST(Wake, OfSteadyMotionIsWholeToTheLastBit) { EXPECT_EQ(formed_after(60), 1); }

TEST(Wake, HardlyFormsInSmallSwings) {
  EXPECT_NEAR(share_in_swings(1), 0.0004, tolerance(1e-4));
  EXPECT_NEAR(share_in_swings(3), 0.027, tolerance(1e-3));
  EXPECT_NEAR(share_in_swings(10), 0.495, tolerance(1e-3));
  EXPECT_NEAR(share_in_swings(20), 0.817, tolerance(1e-3));
}

TEST(Wake, OfABodyThatHasLongMovedStaysAsItIs) {
  support::Random random(1);
  const WakeScale scale = wake_scale(hydro::make_box({1, 2, 3}));
  for (int i = 0; i < 20; ++i) {
    const Matrix3d R_WB = random.rotation().toRotationMatrix();
    const Vector6d u = six(random.vector(1), random.vector(1));
    const Vector6d d = hydro::steady_wake(scale, R_WB, u);
    EXPECT_EQ(formed_wake(scale, R_WB, d), 1);
    EXPECT_NEAR((advanced_wake(scale, R_WB, d, u, 0.7) - d).norm(), 0, tolerance(1e-14));
  }
  EXPECT_EQ(hydro::steady_wake(scale, kUpright, Vector6d::Zero()), Vector6d::Zero());
}

TEST(Wake, DoesNotDependOnTheStepInConstantMotion) {
  support::Random random(2);
  const WakeScale scale = wake_scale(hydro::make_box({1, 2, 3}));
  const Matrix3d R_WB = random.rotation().toRotationMatrix();
  const Vector6d start = six(random.vector(0.5), random.vector(0.5));
  const Vector6d u = six(random.vector(1), random.vector(1));
  const Vector6d half = advanced_wake(scale, R_WB, start, u, 0.4);
  EXPECT_NEAR(
      (advanced_wake(scale, R_WB, half, u, 0.4) - advanced_wake(scale, R_WB, start, u, 0.8)).norm(),
      0, tolerance(1e-14));
}

TEST(Wake, TurnsWithTheBodyAndItsMotion) {
  support::Random random(3);
  const WakeScale scale = wake_scale(hydro::make_box({1, 2, 3}));
  for (int i = 0; i < 20; ++i) {
    const Matrix3d R_WB = random.rotation().toRotationMatrix();
    const Matrix3d turn = random.rotation().toRotationMatrix();
    const Vector3d v = random.vector(1), w = random.vector(1);
    const double f =
        formed_wake(scale, R_WB, advanced_wake(scale, R_WB, Vector6d::Zero(), six(v, w), 1));
    const Matrix3d turned = turn * R_WB;
    const double f_turned = formed_wake(
        scale, turned, advanced_wake(scale, turned, Vector6d::Zero(), six(turn * v, turn * w), 1));
    EXPECT_GT(f, 0);
    EXPECT_LT(f, 1);
    EXPECT_NEAR(f_turned, f, tolerance(1e-13));
  }
}

// A turn counts by the mean square velocity of the surface: 5/18 + 1/18 of that of a cube's corner
// in translation, for a cube of 1 m that turns about an axis of its frame.
TEST(Wake, MeasuresATurnByTheVelocityOfTheSurface) {
  const WakeScale scale = wake_scale(hydro::make_box(Vector3d::Ones(), 3));
  EXPECT_NEAR(scale.length, 0.6, tolerance(1e-15));
  EXPECT_NEAR(scale.square(0, 0), 1, tolerance(1e-14));
  EXPECT_NEAR(scale.square(3, 3), (2 * (1.0 / 4 + 1.0 / 12) * 2 + 2.0 / 6) / 6, tolerance(1e-14));
}

}  // namespace
