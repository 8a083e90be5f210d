#include "app/logs/probes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/assembly/build.h"
#include "engine/simulation.h"
#include "hydro/airy_waves.h"
#include "tests/app/scene_text.h"
#include "tests/support/tolerance.h"

namespace {

using app::ProbeReading;
using Eigen::Vector3d;
using support::tolerance;

struct Scene {
  explicit Scene(const std::string& text)
      : scene(support::read_scene_text(text)),
        built(assembly::build_without_added_mass(scene)),
        probes(scene.probes, built.spec, built.centers_of_mass) {}
  const hydro::Sea& sea() const { return *built.spec.sea; }

  scene::Scene scene;
  assembly::BuiltScene built;
  app::Probes probes;
};

/// A vector of a reading: 1 for the position, 4 for the velocity, 7 for the acceleration.
Vector3d vector_of(const ProbeReading& reading, std::size_t first) {
  return {reading[first], reading[first + 1], reading[first + 2]};
}

const std::string kSea =
    "plimsoll: 1\nduration: 1\n"
    "water:\n"
    "  level: 0.7\n"
    "  depth: 12\n"
    "  current: [0.3, -0.2, 0]\n"
    "  surface: {waves: [{amplitude: 0.6, period: 4, heading_deg: 30},\n"
    "                    {amplitude: 0.3, wavelength: 11, heading_deg: 100, phase_deg: 20}]}\n";

TEST(Probes, AGaugeReadsTheElevationOfTheSea) {
  const Scene s(kSea + "log: {probes: [{name: a, wave: [3, -2]}]}\n");
  for (int i = 0; i < 20; ++i) {
    const double time = 0.37 * i;
    const ProbeReading reading = s.probes.read(time, {}).at(0);
    EXPECT_EQ(reading[0], hydro::surface_elevation(s.sea(), 3, -2, time));
    EXPECT_EQ(vector_of(reading, 1), Vector3d(3, -2, 0.7 + reading[0]));
    for (std::size_t column = 4; column < reading.size(); ++column)
      EXPECT_TRUE(std::isnan(reading[column]));
  }
}

TEST(Probes, AGaugeReadsTheWavesOfBodiesAsWell) {
  const Scene s(kSea + "log: {probes: [{name: a, wave: [3, -2]}]}\n");
  const hydro::SurfacePatch waves{
      .heights = Eigen::MatrixXf::Constant(32, 32, 0.25F), .cell = 1, .origin = {-10, -10}};
  const double given = s.probes.read(4, {}).at(0)[0];
  const ProbeReading reading = s.probes.read(4, {}, waves).at(0);
  EXPECT_NEAR(reading[0], given + 0.25, 1e-12);
  EXPECT_NEAR(reading[3], 0.7 + given + 0.25, 1e-12);
}

TEST(Probes, AGaugeWithADepthReadsTheMotionOfTheWaterThere) {
  const Scene s(kSea + "log: {probes: [{name: a, wave: [3, -2], depth: 2.5}]}\n");
  for (int i = 0; i < 20; ++i) {
    const double time = 0.37 * i;
    const ProbeReading reading = s.probes.read(time, {}).at(0);
    const Vector3d place(3, -2, 0.7 - 2.5);
    const hydro::WaterMotion water = hydro::water_at(s.sea(), place, time);
    EXPECT_EQ(vector_of(reading, 1), place);
    EXPECT_EQ(vector_of(reading, 4), water.velocity);
    EXPECT_EQ(vector_of(reading, 7), water.acceleration);
  }
}

TEST(Probes, APointAboveTheSurfaceHasNoWaterToRead) {
  const Scene s(kSea + "log: {probes: [{name: a, wave: [3, -2], depth: 0}]}\n");
  int wet = 0, dry = 0;
  for (int i = 0; i < 40; ++i) {
    const ProbeReading reading = s.probes.read(0.2 * i, {}).at(0);
    EXPECT_EQ(std::isnan(reading[4]), reading[0] < 0);
    ++(reading[0] < 0 ? dry : wet);
  }
  EXPECT_GT(wet, 5);
  EXPECT_GT(dry, 5);
}

/// A box that turns and falls into the water, with a point at one of its corners.
const std::string kFall =
    "plimsoll: 1\nduration: 1\nstep: 0.01\n"
    "water: {}\n"
    "bodies:\n"
    "  - {name: box, box: {size: [1, 1, 1]}, mass: 600, center_of_mass: [0.1, 0, -0.1],\n"
    "     position: [0, 0, 1.5], angular_velocity: [0.3, 2, -0.4]}\n"
    "log: {probes: [{name: corner, body: box, at: [0.5, 0.5, 0.5]}]}\n";

TEST(Probes, APointOfABodyMovesAsItsPlaceInTheMeshDoes) {
  Scene s(kFall);
  engine::Simulation simulation(s.built.spec);
  for (int i = 0; i < 60; ++i) {
    const hydro::BodyState state = simulation.states()[0];
    const Vector3d arm = state.orientation * Vector3d(0.4, 0.5, 0.6);
    const ProbeReading reading = s.probes.read(simulation.time(), simulation.states()).at(0);
    EXPECT_LT((vector_of(reading, 1) - state.position - arm).norm(), tolerance(1e-14));
    const Vector3d velocity = state.linear_velocity + state.angular_velocity.cross(arm);
    EXPECT_LT((vector_of(reading, 4) - velocity).norm(), tolerance(1e-14));
    EXPECT_EQ(reading[0], 0);
    simulation.step();
  }
}

TEST(Probes, AccelerationsSumToTheVelocity) {
  Scene s(kFall);
  engine::Simulation simulation(s.built.spec);
  const ProbeReading start = s.probes.read(0, simulation.states()).at(0);
  EXPECT_TRUE(std::isnan(start[7]) && std::isnan(start[8]) && std::isnan(start[9]));
  Vector3d velocity = vector_of(start, 4);
  for (int i = 0; i < 100; ++i) {
    s.probes.before_step(simulation.states());
    simulation.step();
    const ProbeReading reading = s.probes.read(simulation.time(), simulation.states()).at(0);
    velocity += s.scene.step * vector_of(reading, 7);
    EXPECT_LT((velocity - vector_of(reading, 4)).norm(), tolerance(1e-13));
  }
}

TEST(Probes, AFallingPointOnTheCentreOfMassAcceleratesByGravity) {
  Scene s(
      "plimsoll: 1\nduration: 1\nstep: 0.01\n"
      "bodies: [{name: a, box: {size: [1, 1, 1]}, density: 5, angular_velocity: [1, 2, 3]}]\n"
      "log: {probes: [{name: p, body: a}]}\n");
  engine::Simulation simulation(s.built.spec);
  s.probes.before_step(simulation.states());
  simulation.step();
  const ProbeReading reading = s.probes.read(simulation.time(), simulation.states()).at(0);
  EXPECT_TRUE(std::isnan(reading[0]));  // there is no water
  EXPECT_LT((vector_of(reading, 7) - Vector3d(0, 0, -9.80665)).norm(), tolerance(1e-12));
}

}  // namespace
