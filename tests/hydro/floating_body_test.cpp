#include "hydro/radiation/floating_body.h"

#include <gtest/gtest.h>

#include "hydro/airy_waves.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/radiating_sphere.h"

namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using hydro::BodyState;
using hydro::FloatingBody;
using hydro::Matrix6d;
using hydro::RadiationData;
using hydro::Sea;

FloatingBody floating_sphere() {
  return {hydro::make_icosphere(1, 3), support::radiating_sphere(1)};
}

TEST(FloatingBody, HasTheAddedMassOfHighFrequencyInOrdinaryMotions) {
  const FloatingBody body = floating_sphere();
  const Matrix6d whole = 1025 * body.data().infinite_added_mass;
  // The sphere reaches a fiftieth of its draught into the water.
  for (const double z : {-3.0, 0.0, 0.5, 0.979})
    EXPECT_LT((body.at({.position = {0, 0, z}}, {.density = 1025}, 0) - whole).norm(),
              1e-12 * whole.norm())
        << z;
}

TEST(FloatingBody, LosesItSmoothlyAsItLeavesTheWater) {
  const FloatingBody body = floating_sphere();
  double last = 1;
  for (double z = 0.97; z < 1.01; z += 1e-4) {
    const double w = body.presence({.position = {0, 0, z}}, {}, 0);
    EXPECT_LE(w, last);
    EXPECT_GT(w, last - 1.5 * 1e-4 / 0.02 - 1e-12);  // The steepest slope of a cubic step.
    last = w;
  }
  EXPECT_EQ(last, 0);
  EXPECT_NEAR(body.presence({.position = {0, 0, 0.99}}, {}, 0), 0.5, 0.02);
  EXPECT_EQ(body.at({.position = {0, 0, 1}}, {}, 0), Matrix6d::Zero());
}

TEST(FloatingBody, IsPresentWhereverItsLowestPointIs) {
  // A box on its edge, under a crest, and in water of another level.
  RadiationData data = support::radiating_sphere(1);
  const FloatingBody body(hydro::make_box({2, 2, 2}, 1), data);
  const Quaterniond heel(AngleAxisd(M_PI / 4, Vector3d::UnitX()));
  EXPECT_EQ(body.presence({.position = {0, 0, 1.3}, .orientation = heel}, {}, 0), 1);
  EXPECT_EQ(body.presence({.position = {0, 0, 1.42}, .orientation = heel}, {}, 0), 0);
  EXPECT_EQ(body.presence({.position = {0, 0, 8.3}, .orientation = heel}, {.level = 7}, 0), 1);
  Sea sea;
  sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.5, 100, 0, 0, sea.gravity)}};
  EXPECT_EQ(body.presence({.position = {0, 0, 1.4}}, sea, 0), 1);
  EXPECT_EQ(body.presence({.position = {50, 0, 0.7}}, sea, 0), 0);
}

TEST(FloatingBody, TurnsItsAddedMassToTheAxesOfTheMesh) {
  RadiationData data = support::radiating_sphere(1);
  data.pose.orientation = AngleAxisd(M_PI / 2, Vector3d::UnitY());  // The mesh's x axis looks down.
  const FloatingBody body(hydro::make_icosphere(1, 3), data);
  const Matrix6d A = body.at({.orientation = data.pose.orientation}, {.density = 1}, 0);
  EXPECT_NEAR(A(0, 0), data.infinite_added_mass(2, 2), 1e-12);
  EXPECT_NEAR(A(2, 2), data.infinite_added_mass(0, 0), 1e-12);
}

// The water that a ball moves does not know how it is turned: its matrix in W is that of the mean
// pose.
TEST(FloatingBody, KeepsTheAddedMassOfABallThatRolls) {
  const RadiationData data = support::radiating_sphere(1);
  const FloatingBody body(hydro::make_icosphere(1, 3), data);
  EXPECT_EQ(body.slides(), hydro::WaveFrameRule::Slides::all);
  const Quaterniond rolled(AngleAxisd(2.1, Vector3d(0.6, -0.3, 0.2).normalized()));
  const Matrix6d in_W = hydro::WaveFrame{.R_WH = rolled}.tensor_out(
      body.at({.orientation = rolled}, {.density = 1}, 0));
  EXPECT_LT((in_W - data.infinite_added_mass).norm(), 1e-14);
}

TEST(FloatingBody, ScattersWavesWhileItIsInTheWater) {
  const auto diffraction = [](const BodyState&, const hydro::WaveFrame&, const Sea& sea,
                              double time) {
    return hydro::Wrench{.force = {sea.density * time, 0, 0}};
  };
  const FloatingBody body(hydro::make_icosphere(1, 3), support::radiating_sphere(1), diffraction);
  EXPECT_EQ(body.wave_load({}, {.density = 1000}, 2).force.x(), 2000);
  EXPECT_EQ(body.wave_load({.position = {0, 0, 2}}, {.density = 1000}, 2).force.x(), 0);
  EXPECT_EQ(floating_sphere().wave_load({}, {.density = 1000}, 2).force.x(), 0);
}

}  // namespace
