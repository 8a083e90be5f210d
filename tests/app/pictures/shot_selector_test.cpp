#include "app/pictures/shot_selector.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/logs/interpolation.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using app::Shot;
using app::ShotSelector;
using testing::ElementsAre;

/// Cubic interpolation of a parabola is exact but for round-off.
const double kCubicRoundOff = support::tolerance(1e-14);

/// One body that falls from rest, 1 m/s^2.
hydro::BodyState falling(double time) {
  hydro::BodyState state;
  state.position.z() = -0.5 * time * time;
  state.linear_velocity.z() = -time;
  return state;
}

std::vector<Shot> all_of(const app::ShotSpool& store) {
  std::vector<Shot> shots;
  for (std::size_t i = 0; i < store.size(); ++i) shots.push_back(store.at(i));
  return shots;
}

/// Those of a run in steps to the end.
std::vector<Shot> shots_of(ShotSelector list, double step, int steps, double first = 0) {
  for (int i = 0; i <= steps; ++i) list.add(first + i * step, {falling(first + i * step)});
  return all_of(list.shots());
}

std::vector<double> times(const std::vector<Shot>& shots, bool Shot::*which) {
  std::vector<double> times;
  for (const Shot& shot : shots)
    if (shot.*which) times.push_back(shot.time);
  return times;
}

TEST(ShotSelector, WithoutAVideoHasTheFirstStateOfEachTimeThatIsDue) {
  const std::vector<Shot> shots = shots_of(ShotSelector(0.25, 1, 0), 0.125, 8);
  EXPECT_THAT(times(shots, &Shot::frame), ElementsAre(0, 0.25, 0.5, 0.75, 1));
  EXPECT_THAT(times(shots, &Shot::video), ElementsAre());
}

TEST(ShotSelector, HasTheFinalStateWheneverItIs) {
  for (const double every : {0.3, 0.5, 0.9, 7.0})
    for (const double step : {0.07, 0.1, 0.3}) {
      const int steps = static_cast<int>(std::ceil(2 / step - 1e-9));
      const std::vector<double> found =
          times(shots_of(ShotSelector(every, 2, 0), step, steps + 3), &Shot::frame);
      EXPECT_EQ(found.back(), steps * step) << every << " " << step;
      EXPECT_EQ(std::count(found.begin(), found.end(), found.back()), 1);
    }
}

TEST(ShotSelector, OfAVideoPlaysInRealTimeWhateverTheStep) {
  for (const double step : {1.0 / 60, 0.01, 0.04, 0.1, 0.3, 3.0})
    for (const int fps : {1, 24, 25, 30, 120}) {
      const int steps = static_cast<int>(std::ceil(3 / step - 1e-9));
      const std::vector<double> found =
          times(shots_of(ShotSelector(1, 3, fps), step, steps), &Shot::video);
      ASSERT_EQ(found.size(), static_cast<std::size_t>(3 * fps)) << step << " " << fps;
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], static_cast<double>(i) / fps, 1e-6 / fps);
    }
}

TEST(ShotSelector, FindsStatesBetweenSteps) {
  for (const Shot& shot : shots_of(ShotSelector(1, 3, 25), 0.3, 10))
    EXPECT_NEAR(shot.states[0].position.z(), falling(shot.time).position.z(), kCubicRoundOff);
}

/// One propeller that turns by 1 rad/s.
app::DrawnRig turning(double time) {
  return {.lines = {}, .propellers = {{.turn = time, .azimuth = 0}}, .foil_angles = {}};
}

TEST(ShotSelector, FindsTheRigBetweenStepsAndAfterAPause) {
  ShotSelector whole(1, 3, 25), first(1, 3, 25), second(1, 3, 25);
  for (int i = 0; i <= 10; ++i) {
    const double time = 0.3 * i;
    const auto rig = [&] { return turning(time); };
    whole.add(time, {falling(time)}, {}, rig);
    (i <= 4 ? first : second).add(time, {falling(time)}, {}, rig);
    if (i != 4) continue;
    app::ShotSpool kept;
    for (const Shot& shot : all_of(first.shots())) kept.add(shot);
    second.resume(time, {falling(time)}, turning(time), std::move(kept));
  }
  for (const Shot& shot : all_of(whole.shots()))
    EXPECT_NEAR(shot.rig.propellers.at(0).turn, shot.time, kCubicRoundOff);
  EXPECT_EQ(all_of(second.shots()), all_of(whole.shots()));
}

TEST(ShotSelector, DrawsOnceWhatIsAFrameAndOfTheVideo) {
  const std::vector<Shot> shots = shots_of(ShotSelector(0.5, 2, 4), 0.25, 8);
  EXPECT_EQ(shots.size(), 9u);
  EXPECT_THAT(times(shots, &Shot::frame), ElementsAre(0, 0.5, 1, 1.5, 2));
  EXPECT_EQ(times(shots, &Shot::video).size(), 8u);
}

TEST(ShotSelector, LeavesTheFramesAsTheyAreWithoutAVideo) {
  const std::vector<Shot> bare = shots_of(ShotSelector(0.3, 2, 0), 0.07, 28);
  std::vector<Shot> frames;
  for (const Shot& shot : shots_of(ShotSelector(0.3, 2, 25), 0.07, 28))
    if (shot.frame) frames.push_back(shot);
  ASSERT_EQ(frames.size(), bare.size());
  for (std::size_t i = 0; i < bare.size(); ++i) {
    EXPECT_EQ(frames[i].time, bare[i].time);
    EXPECT_EQ(frames[i].states, bare[i].states);
  }
}

TEST(ShotSelector, OfNoDurationHasTheInitialState) {
  const std::vector<Shot> shots = shots_of(ShotSelector(0.3, 0, 25), 1, 0);
  ASSERT_EQ(shots.size(), 1u);
  EXPECT_TRUE(shots[0].frame && shots[0].video);
}

TEST(ShotSelector, BeginsWhereTheStatesDo) {
  const std::vector<Shot> shots = shots_of(ShotSelector(1, 3, 4), 0.5, 4, 1.1);
  EXPECT_THAT(times(shots, &Shot::video), ElementsAre(1.25, 1.5, 1.75, 2, 2.25, 2.5, 2.75));
}

TEST(ShotSpool, GivesBackWhatWasAddedInAnyOrder) {
  support::Random random(5);
  app::ShotSpool store;
  std::vector<Shot> shots;
  for (int i = 0; i < 20; ++i) {
    shots.push_back({.time = random.uniform(0, 9),
                     .states = {random.state(3, 4), random.state(1e3, 9)},
                     .frame = i % 3 == 0,
                     .video = i % 2 == 0});
    Shot& shot = shots.back();
    for (int k = 0; k < i % 3; ++k) {
      shot.rig.lines.push_back({.tension = random.uniform(0, 9), .length = 2, .broken = k == 1});
      for (int node = 0; node < i % 5 - k; ++node)
        shot.rig.lines.back().nodes_W.emplace_back(random.uniform(0, 9), i, node);
      shot.rig.propellers.push_back({.turn = random.uniform(0, 9), .azimuth = 1});
      shot.rig.foil_angles.push_back(random.uniform(-1, 1));
      shot.interiors = {{{.at_W = {1, 2, 3}, .level = 4, .flooded = true}}, {}};
    }
    store.add(shots.back());
    EXPECT_EQ(store.at(0), shots[0]);
  }
  EXPECT_EQ(all_of(store), shots);
  EXPECT_EQ(store.frames(), 7u);
  EXPECT_EQ(store.of_video(), 10u);
}

TEST(ShotSpool, OfASceneWithoutBodiesHasTimes) {
  app::ShotSpool store;
  store.add({.time = 0.5});
  store.add({.time = 0.75});
  EXPECT_EQ(store.at(0).time, 0.5);
  EXPECT_TRUE(store.at(1).states.empty());
}

TEST(Interpolation, KeepsBothEnds) {
  hydro::BodyState a = falling(1), b = falling(2);
  b.orientation = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  b.angular_velocity = {1, 0, -1};
  for (const auto& [part, end] : {std::pair(0.0, a), std::pair(1.0, b)}) {
    const hydro::BodyState state = app::between(a, b, 1, part);
    EXPECT_LE((state.position - end.position).norm(), kCubicRoundOff);
    EXPECT_LE(state.orientation.angularDistance(end.orientation), kCubicRoundOff);
    EXPECT_EQ(state.linear_velocity, end.linear_velocity);
    EXPECT_EQ(state.angular_velocity, end.angular_velocity);
  }
}

/// The waves of a ball that falls into the water, by the shots and by themselves.
TEST(ShotSelector, StoresTheBodiesWaves) {
  const hydro::TriMesh ball = hydro::make_icosphere(1, 1);
  const hydro::PeriodicSquare square{.cells = 32, .cell = 0.5};
  hydro::SimulatedWater alone(hydro::Sea(), {{&ball, 1}}, square);
  ShotSelector list(0.5, 2, 3);
  list.show_waves(hydro::SimulatedWater(hydro::Sea(), {{&ball, 1}}, square));
  for (int i = 0; i <= 20; ++i) {
    const double time = 0.1 * i;
    list.add(time, {falling(time)});
    alone.follow(time, {falling(time)});
  }
  EXPECT_TRUE(list.state_of_waves() == alone.state());
  const std::vector<Shot> shots = all_of(list.shots());
  EXPECT_FALSE(shots.front().water);  // Nothing has moved yet.
  const auto last = alone.patch(2);
  ASSERT_TRUE(shots.back().water && last);
  EXPECT_EQ(shots.back().water->origin, last->origin);
  EXPECT_EQ(shots.back().water->cell, last->cell);
  // Heights are stored in 16 bits.
  EXPECT_LT((shots.back().water->heights - last->heights).cwiseAbs().maxCoeff(),
            support::tolerance(2e-5) * last->heights.cwiseAbs().maxCoeff());
}

TEST(ShotSelector, StoresNoWavesWithoutThem) {
  for (const Shot& shot : shots_of(ShotSelector(0.5, 2, 4), 0.25, 8)) EXPECT_FALSE(shot.water);
}

}  // namespace
