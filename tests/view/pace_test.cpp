#include "app/view/pace.h"

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"

namespace {

using app::Pace;
using support::tolerance;

constexpr double kStepTime = 0.01;   // [s]
constexpr double kFrame = 1.0 / 60;  // of a screen [s]

/// Steps of so many frames.
long steps_in(Pace& pace, int frames) {
  long steps = 0;
  for (int i = 0; i < frames; ++i) steps += pace.steps_due(kFrame);
  return steps;
}

TEST(Pace, FollowsTheClock) {
  Pace pace(kStepTime);
  EXPECT_NEAR(static_cast<double>(steps_in(pace, 600)), 1000, 1);
}

TEST(Pace, FollowsTheClockTimesTheSpeed) {
  Pace pace(kStepTime);
  pace.faster();
  EXPECT_NEAR(static_cast<double>(steps_in(pace, 600)), 2000, 1);
  for (int i = 0; i < 3; ++i) pace.slower();
  EXPECT_NEAR(static_cast<double>(steps_in(pace, 600)), 250, 1);
}

TEST(Pace, KeepsItsSpeedWithinASixteenthAndSixteen) {
  Pace pace(kStepTime);
  for (int i = 0; i < 20; ++i) pace.faster();
  EXPECT_EQ(pace.speed(), 16);
  for (int i = 0; i < 20; ++i) pace.slower();
  EXPECT_EQ(pace.speed(), 1.0 / 16);
}

TEST(Pace, ForgivesWhatTheMachineCannotCatchUpWith) {
  Pace pace(kStepTime);
  EXPECT_EQ(pace.steps_due(30), 25);  // as many as the longest debt has
  EXPECT_EQ(pace.steps_due(0), 0);
  EXPECT_EQ(pace.steps_due(kStepTime), 1);
}

TEST(Pace, TakesStepsThatAreLongerThanTheLongestDebt) {
  Pace pace(0.5);
  long steps = 0;
  for (int i = 0; i < 600; ++i) steps += pace.steps_due(kFrame);
  EXPECT_NEAR(static_cast<double>(steps), 20, 1);
}

TEST(Pace, WaitsForTheNextStep) {
  Pace pace(kStepTime);
  pace.slower();
  EXPECT_EQ(pace.steps_due(0.008), 0);
  EXPECT_NEAR(pace.until_next(), 0.012, tolerance(1e-12));
  EXPECT_EQ(pace.steps_due(0.012), 1);
}

TEST(Pace, TakesNoStepsWhilePausedButThoseAskedFor) {
  Pace pace(kStepTime);
  pace.step_once();  // not paused: nothing
  pace.pause_or_go_on();
  EXPECT_TRUE(pace.paused());
  EXPECT_EQ(pace.steps_due(1), 0);
  pace.step_once();
  pace.step_once();
  EXPECT_EQ(pace.steps_due(0.01), 2);
  EXPECT_EQ(pace.steps_due(1), 0);
}

TEST(Pace, DoesNotMakeUpForAPause) {
  Pace pace(kStepTime);
  pace.pause_or_go_on();
  pace.steps_due(0.09);
  pace.pause_or_go_on();
  EXPECT_EQ(pace.steps_due(0.03), 3);
}

TEST(Pace, TellsWhatWasReached) {
  Pace pace(kStepTime);
  EXPECT_EQ(pace.reached(), 0);
  for (int i = 0; i < 30; ++i) pace.note(kFrame * 1.01, 1);
  EXPECT_NEAR(pace.reached(), kStepTime / (kFrame * 1.01), tolerance(1e-12));
  pace.pause_or_go_on();
  for (int i = 0; i < 100; ++i) pace.note(kFrame, 0);
  EXPECT_GT(pace.reached(), 0.5);
}

}  // namespace
