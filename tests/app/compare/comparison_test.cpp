#include "app/compare/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/compare/learned_tolerances.h"
#include "app/logs/table_layouts.h"
#include "app/scene/diagnostics.h"

namespace {

using app::BodyTrack;
using app::Comparison;
using app::Tolerance;
using app::Tolerances;
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

/// A run of one line with these tensions at 0, 1, … s.
app::ComparedRun with_tensions(const std::vector<double>& tensions) {
  const app::TableLayout layout = app::lines_layout();
  app::TableTrack track;
  for (std::size_t i = 0; i < tensions.size(); ++i) track.times.push_back(static_cast<double>(i));
  track.columns.assign(layout.width(), std::vector<double>(tensions.size()));
  track.columns[layout.column("tension")] = tensions;
  return {.trajectory = logged(0, 1, static_cast<int>(tensions.size())),
          .tables = {{"lines", {.layout = layout, .names = {"s"}, .tracks = {{"s", track}}}}},
          .summary = {}};
}

const app::Difference& tension(const Comparison& comparison) {
  return comparison.tables.at(0).names.at(0).differences.at(0);
}

Tolerances of_tension(const Tolerance& tolerance) {
  return {.all = {{"lines.tension", tolerance}}, .bodies = {}};
}

TEST(Comparison, JudgesPeakRootMeanSquareAndShare) {
  const auto a = with_tensions({100, -200, 100, 0}), b = with_tensions({100, -203, 104, 0});
  const auto with = [&](const Tolerance& t) { return compare_runs(a, b, of_tension(t)); };
  EXPECT_EQ(tension(with({.peak = 3})).first_beyond, 2);
  EXPECT_EQ(tension(with({.peak = 3})).largest, 4);
  EXPECT_EQ(tension(with({.peak = 3})).size, 200);
  EXPECT_EQ(tension(with({.peak = 3})).rms, 2.5);
  EXPECT_TRUE(with({.peak = 4}).same());
  EXPECT_TRUE(with({.relative = 0.02}).same());
  EXPECT_FALSE(with({.relative = 0.019}).same());
  EXPECT_TRUE(with({.peak = 0.2, .relative = 0.019}).same());
  EXPECT_TRUE(with({.rms = 2.5}).same());
  EXPECT_FALSE(with({.rms = 2.4}).same());
  EXPECT_EQ(tension(with({.rms = 2.4})).first_beyond, app::Difference::kNever);
}

TEST(Comparison, ANumberThatOnlyOneHasIsInfinitelyFar) {
  const auto with = with_tensions({1, 2}), without = with_tensions({1, std::nan("")});
  EXPECT_TRUE(compare_runs(without, without, {}).same());
  EXPECT_FALSE(compare_runs(with, without, of_tension({.peak = 1e300})).same());
}

TEST(Comparison, ATableOfOneRunIsADifferenceIfItIsJudged) {
  const auto with = with_tensions({1, 2});
  app::ComparedRun without = with;
  without.tables.clear();
  EXPECT_FALSE(compare_runs(with, without, {}).same());
  EXPECT_FALSE(compare_runs(without, with, of_tension({.peak = 1})).same());
  EXPECT_TRUE(
      compare_runs(with, without, {.all = {{"position", {.peak = 1}}}, .bodies = {}}).same());
}

TEST(Tolerances, OfABodyComeBeforeThoseOfAllAndThoseOfAQuantityBeforeItsTable) {
  const Tolerances some{
      .all = {{"position", {.peak = 0.1}}, {"lines", {.rms = 1}}},
      .bodies = {{"p", {{"position", {.peak = 2}}, {"lines.taut", {.peak = 0}}}}}};
  EXPECT_EQ(some.of("p", "position").peak, 2);
  EXPECT_EQ(some.of("q", "position").peak, 0.1);
  EXPECT_FALSE(some.of("p", "linear_velocity").judges());
  EXPECT_EQ(some.of("p", "lines.taut").peak, 0);
  EXPECT_EQ(some.of("p", "lines.tension").rms, 1);
  EXPECT_FALSE(some.of("p", "forces.weight").judges());
  EXPECT_EQ(Tolerances{}.of("p", "position").peak, Tolerances::kDefault);
}

TEST(LearnedTolerances, HoldForTheRunsThatTheyAreFromAndNotForLess) {
  const auto a = with_tensions({100, -200, 100, 0}), b = with_tensions({100, -203, 104, 0});
  const std::vector<Comparison> all = {compare_runs(a, b, {}), compare_runs(a, a, {})};
  const Tolerances learned = app::learned_tolerances(all, 1, {"b", "a"});
  EXPECT_EQ(learned.of("s", "lines.tension"), (Tolerance{.peak = 4, .rms = 2.5}));
  EXPECT_EQ(learned.of("s", "lines.length"), (Tolerance{.peak = 1e-9}));
  EXPECT_TRUE(compare_runs(a, b, learned).same());
  EXPECT_FALSE(compare_runs(a, with_tensions({100, -200, 104.1, 0}), learned).same());
  EXPECT_EQ(app::learned_tolerances(all, 3, {"b", "a"}).of("s", "lines.tension").peak, 12);
}

TEST(LearnedTolerances, OfRunsWithOtherRowsAreAFault) {
  const std::vector<Comparison> all = {compare_runs(with_tensions({1, 2}), with_tensions({1}), {})};
  EXPECT_THROW(app::learned_tolerances(all, 1, {"b"}), scene::InputError);
}

TEST(Tolerances, AreReadBackFromTheirText) {
  const Tolerances some{.all = {{"position", {.peak = 0.1}},
                                {"lines", {.peak = 3}},
                                {"lines.tension", {.rms = 1, .relative = 1e-6}}},
                        .bodies = {{"a b", {{"forces.lift", {.peak = 2, .rms = 1}}}}}};
  const auto file = std::filesystem::path(testing::TempDir()) / "learned_tolerances.yaml";
  std::ofstream(file) << yaml_of(some);
  const Tolerances read = app::read_tolerances(file);
  std::filesystem::remove(file);
  EXPECT_EQ(read.all, some.all);
  EXPECT_EQ(read.bodies, some.bodies);
}

}  // namespace
