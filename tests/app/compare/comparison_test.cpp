#include "app/compare/comparison.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using app::BodyTrack;
using app::Comparison;
using app::Trajectory;
using Eigen::Vector3d;

/// On a helix, turning about an axis that turns itself.
hydro::BodyState on_helix(double t) {
  const Vector3d first(0.3, 0, 0.9), second(0, 0.7, 0);
  const Eigen::Quaterniond outer(Eigen::AngleAxisd(first.norm() * t, first.normalized()));
  const Eigen::Quaterniond inner(Eigen::AngleAxisd(second.norm() * t, second.normalized()));
  return {.position = {std::cos(t), std::sin(t), 0.2 * t},
          .orientation = outer * inner,
          .linear_velocity = {-std::sin(t), std::cos(t), 0.2},
          .angular_velocity = first + outer * second};
}

Trajectory logged(double first, double interval, int rows) {
  BodyTrack track;
  for (int i = 0; i < rows; ++i) {
    track.times.push_back(first + i * interval);
    track.states.push_back(on_helix(track.times.back()));
  }
  return {.names = {"p"}, .tracks = {{"p", track}}};
}

double largest(const Comparison& comparison, int quantity) {
  return comparison.bodies.at(0).differences.at(static_cast<std::size_t>(quantity)).largest;
}

TEST(Comparison, InterpolatesPlaceAndAttitudeToTheFourthOrder) {
  // The error of Hermite's cubic is h⁴ x''''/384; here |x''''| = 1.
  for (const double h : {0.2, 0.1, 0.05}) {
    const Comparison c =
        compare_trajectories(logged(0, h, 41), logged(h / 2, 2 * h, 20), {.all = {}, .bodies = {}});
    EXPECT_EQ(c.bodies[0].interpolated, 20U);
    EXPECT_NEAR(largest(c, 0), std::pow(h, 4) / 384, 0.01 * std::pow(h, 4) / 384);
    EXPECT_LT(largest(c, 1) * M_PI / 180, std::pow(h, 4) / 100);
    EXPECT_GT(largest(c, 1), 0);
    // On the line between velocities: h²/8 of the second derivative, 1.
    EXPECT_NEAR(largest(c, 2), h * h / 8, 0.01 * h * h);
  }
}

TEST(Comparison, TakesRowsAsTheyAreWhereBothHaveThem) {
  const Comparison c =
      compare_trajectories(logged(0, 0.1, 21), logged(0, 0.2, 11), {.all = {}, .bodies = {}});
  EXPECT_EQ(c.bodies[0].times.size(), 11U);
  EXPECT_EQ(c.bodies[0].interpolated, 0U);
  EXPECT_EQ(c.bodies[0].only_a + c.bodies[0].only_b, 0U);
  EXPECT_LT(largest(c, 0), 1e-12);  // 0.1 · 2 and 0.2 · 1 are not the same number.
  EXPECT_TRUE(c.same());
}

TEST(Comparison, ALogThatEndsEarlierIsADifference) {
  const Comparison c =
      compare_trajectories(logged(0, 0.1, 21), logged(0, 0.1, 15), {.all = {}, .bodies = {}});
  EXPECT_EQ(c.bodies[0].only_a, 6U);
  EXPECT_EQ(c.bodies[0].only_b, 0U);
  EXPECT_FALSE(c.same());
}

TEST(Comparison, LogsWithNoTimeInCommonAreADifference) {
  EXPECT_FALSE(
      compare_trajectories(logged(0, 0.1, 3), logged(5, 0.1, 3), {.all = {}, .bodies = {}}).same());
}

TEST(Tolerances, OfABodyComeBeforeThoseOfAll) {
  const app::Tolerances some{.all = {{"position", 0.1}}, .bodies = {{"p", {{"position", 2}}}}};
  EXPECT_EQ(some.of("p", "position"), 2);
  EXPECT_EQ(some.of("q", "position"), 0.1);
  EXPECT_EQ(some.of("p", "linear_velocity"), app::Tolerances::kNotJudged);
  EXPECT_EQ(app::Tolerances{}.of("p", "position"), app::Tolerances::kDefault);
}

}  // namespace
