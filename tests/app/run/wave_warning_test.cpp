#include "app/run/wave_warning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hydro/airy_waves.h"
#include "hydro/mesh/primitives.h"

namespace {

using testing::Optional;
using testing::StartsWith;

/// A box that lies half in waves of 1.13 s.
engine::SimulationSpec box_in_waves(double step) {
  engine::SimulationSpec spec;
  spec.step = step;
  spec.sea.emplace();
  spec.sea->surface = hydro::WaveSurface{{hydro::deep_water_wave(0.02, 2, 0, 0, 9.81)}};
  spec.bodies.resize(1);
  spec.bodies[0].name = "box";
  spec.bodies[0].mesh_B = hydro::make_box({1, 1, 1});
  return spec;
}

std::optional<std::string> warning(const engine::SimulationSpec& spec,
                                   const Eigen::Vector3d& velocity = Eigen::Vector3d::Zero(),
                                   double height = 0) {
  hydro::BodyState state;
  state.position.z() = height;
  state.linear_velocity = velocity;
  return app::wave_warning(spec, {state});
}

TEST(WaveWarning, SaysThatAStepIsTooLongForTheWavesABodyMeets) {
  EXPECT_THAT(warning(box_in_waves(0.25)),
              Optional(StartsWith("body 'box' meets a wave every 1.13 s, 4.5 steps of 0.25 s")));
  EXPECT_FALSE(warning(box_in_waves(0.02)));
}

TEST(WaveWarning, DependsOnTheSpeedAgainstTheWaves) {
  EXPECT_FALSE(warning(box_in_waves(0.1)));
  EXPECT_TRUE(warning(box_in_waves(0.1), {-5, 0, 0}));
  EXPECT_FALSE(warning(box_in_waves(0.25), {2.5, 0, 0}));
}

TEST(WaveWarning, LeavesOutWavesThatAreSmallAndBodiesThatTheWaterDoesNotMove) {
  engine::SimulationSpec spec = box_in_waves(0.25);
  EXPECT_FALSE(warning(spec, {0, 0, 0}, 2));
  std::get<hydro::WaveSurface>(spec.sea->surface)
      .components.push_back(hydro::deep_water_wave(0.3, 100, 0, 0, 9.81));
  EXPECT_FALSE(warning(spec));
  spec = box_in_waves(0.25);
  spec.bodies[0].locked.fill(true);
  EXPECT_FALSE(warning(spec));
  spec = box_in_waves(0.25);
  spec.bodies[0].wet = false;
  EXPECT_FALSE(warning(spec));
}

}  // namespace
