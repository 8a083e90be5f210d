#include "app/view/playback_clock.h"

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"

namespace {

using app::PlaybackClock;
using support::tolerance;

constexpr double kStepTime = 0.01;   // [s]
constexpr double kFrame = 1.0 / 60;  // of a screen [s]

/// Steps of so many frames.
long steps_in(PlaybackClock& playback, int frames) {
  long steps = 0;
  for (int i = 0; i < frames; ++i) steps += playback.steps_due(kFrame);
  return steps;
}

TEST(PlaybackClock, FollowsTheClock) {
  PlaybackClock playback(kStepTime);
  EXPECT_NEAR(static_cast<double>(steps_in(playback, 600)), 1000, 1);
}

TEST(PlaybackClock, FollowsTheClockTimesTheSpeed) {
  PlaybackClock playback(kStepTime);
  playback.faster();
  EXPECT_NEAR(static_cast<double>(steps_in(playback, 600)), 2000, 1);
  for (int i = 0; i < 3; ++i) playback.slower();
  EXPECT_NEAR(static_cast<double>(steps_in(playback, 600)), 250, 1);
}

TEST(PlaybackClock, KeepsItsSpeedWithinASixteenthAndSixteen) {
  PlaybackClock playback(kStepTime);
  for (int i = 0; i < 20; ++i) playback.faster();
  EXPECT_EQ(playback.speed(), 16);
  for (int i = 0; i < 20; ++i) playback.slower();
  EXPECT_EQ(playback.speed(), 1.0 / 16);
}

TEST(PlaybackClock, ForgivesWhatTheMachineCannotCatchUpWith) {
  PlaybackClock playback(kStepTime);
  EXPECT_EQ(playback.steps_due(30), 25);  // as many as the longest debt has
  EXPECT_EQ(playback.steps_due(0), 0);
  EXPECT_EQ(playback.steps_due(kStepTime), 1);
}

TEST(PlaybackClock, TakesStepsThatAreLongerThanTheLongestDebt) {
  PlaybackClock playback(0.5);
  long steps = 0;
  for (int i = 0; i < 600; ++i) steps += playback.steps_due(kFrame);
  EXPECT_NEAR(static_cast<double>(steps), 20, 1);
}

TEST(PlaybackClock, WaitsForTheNextStep) {
  PlaybackClock playback(kStepTime);
  playback.slower();
  EXPECT_EQ(playback.steps_due(0.008), 0);
  EXPECT_NEAR(playback.until_next(), 0.012, tolerance(1e-12));
  EXPECT_EQ(playback.steps_due(0.012), 1);
}

TEST(PlaybackClock, TakesNoStepsWhilePausedButThoseAskedFor) {
  PlaybackClock playback(kStepTime);
  playback.step_once();  // not paused: nothing
  playback.pause_or_go_on();
  EXPECT_TRUE(playback.paused());
  EXPECT_EQ(playback.steps_due(1), 0);
  playback.step_once();
  playback.step_once();
  EXPECT_EQ(playback.steps_due(0.01), 2);
  EXPECT_EQ(playback.steps_due(1), 0);
}

TEST(PlaybackClock, DoesNotMakeUpForAPause) {
  PlaybackClock playback(kStepTime);
  playback.pause_or_go_on();
  playback.steps_due(0.09);
  playback.pause_or_go_on();
  EXPECT_EQ(playback.steps_due(0.03), 3);
}

TEST(PlaybackClock, TellsWhatWasReached) {
  PlaybackClock playback(kStepTime);
  EXPECT_EQ(playback.reached(), 0);
  for (int i = 0; i < 30; ++i) playback.note(kFrame * 1.01, 1);
  EXPECT_NEAR(playback.reached(), kStepTime / (kFrame * 1.01), tolerance(1e-12));
  playback.pause_or_go_on();
  for (int i = 0; i < 100; ++i) playback.note(kFrame, 0);
  EXPECT_GT(playback.reached(), 0.5);
}

}  // namespace
