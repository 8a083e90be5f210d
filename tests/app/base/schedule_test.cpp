#include "app/base/schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using app::is_frame_time;
using app::Schedule;
using app::step_count;
using testing::ElementsAre;

/// Numbers of the steps that are due.
std::vector<int> due_steps(double every, double step, int steps) {
  Schedule schedule(every);
  std::vector<int> due;
  for (int i = 0; i <= steps; ++i)
    if (schedule.due(i * step)) due.push_back(i);
  return due;
}

TEST(Schedule, StartsAtTimeZero) {
  EXPECT_TRUE(Schedule(0.3).due(0));
  EXPECT_TRUE(Schedule(1e300).due(0));
}

TEST(Schedule, OfZeroIsEveryTimeAskedAbout) { EXPECT_EQ(due_steps(0, 0.01, 1000).size(), 1001u); }

// 0.1 is no binary fraction: i·0.01 lies on both sides of the multiples of 0.1, by rounding.
TEST(Schedule, DoesNotSlipByAStepThroughRounding) {
  const std::vector<int> due = due_steps(0.1, 0.01, 1'000'000);
  ASSERT_EQ(due.size(), 100'001u);
  for (std::size_t i = 0; i < due.size(); ++i) ASSERT_EQ(due[i], static_cast<int>(10 * i));
}

TEST(Schedule, TakesTheFirstStepAtOrAfterEachTimeOfIts) {
  EXPECT_THAT(due_steps(0.25, 0.1, 10), ElementsAre(0, 3, 5, 8, 10));
}

TEST(Schedule, FinerThanTheStepsIsEveryStep) {
  EXPECT_EQ(due_steps(1e-3, 0.1, 100).size(), 101u);
  EXPECT_EQ(due_steps(1e-300, 0.1, 100).size(), 101u);
}

TEST(StepCount, ReachesTheEndAndNotAStepBeyond) {
  EXPECT_EQ(step_count(0, 0.01), 0);
  EXPECT_EQ(step_count(1, 0.3), 4);
  EXPECT_EQ(step_count(0.001, 10), 1);
  EXPECT_EQ(step_count(1e5, 1e-6), 100'000'000'000);
}

TEST(StepCount, OfAWholeNumberOfStepsIsThatNumber) {
  for (const double step : {0.1, 0.01, 0.001, 1.0 / 60, 1.0 / 3, 0.7})
    for (long steps = 1; steps < 20'000; ++steps)
      ASSERT_EQ(step_count(static_cast<double>(steps) * step, step), steps) << step;
}

TEST(FrameTime, IsBeforeTheEndSaveForASceneWithoutDuration) {
  EXPECT_TRUE(is_frame_time(0, 0));
  EXPECT_TRUE(is_frame_time(0, 1));
  EXPECT_TRUE(is_frame_time(0.99, 1));
  EXPECT_FALSE(is_frame_time(1, 1));
  EXPECT_FALSE(is_frame_time(0.1 * 36, 3.6));
}

}  // namespace
