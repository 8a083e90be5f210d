#include <gtest/gtest.h>

#include "app/assembly/signals.h"
#include "app/run/checkpoint.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/radiating_sphere.h"

namespace {

std::string digest_with(const hydro::RadiationData& data) {
  engine::BodySpec body{.name = "ball", .mesh_B = hydro::make_icosphere(1, 1)};
  body.radiation = std::make_shared<const hydro::FloatingBody>(body.mesh_B, data);
  return app::digest_of({.bodies = {body}});
}

TEST(CheckpointDigest, TellsWhetherTheWavesOfABodyHaveChanged) {
  const hydro::RadiationData data = support::radiating_sphere(1);
  EXPECT_EQ(digest_with(data), digest_with(data));
  hydro::RadiationData other = data;
  other.damping[3](2, 2) *= 1 + 1e-12;
  EXPECT_NE(digest_with(data), digest_with(other));
  other = data;
  other.infinite_added_mass(0, 0) *= 1 + 1e-12;
  EXPECT_NE(digest_with(data), digest_with(other));
}

std::string digest_with(std::vector<double> values, scene::Interpolation interpolation) {
  engine::SimulationSpec spec;
  spec.controls.emplace_back().source = assembly::table_signal({0, 1}, values, interpolation);
  return app::digest_of(spec);
}

TEST(CheckpointDigest, TellsWhetherTheTableOfAControlHasChanged) {
  const std::string before = digest_with({2, 3}, scene::Interpolation::linear);
  EXPECT_EQ(digest_with({2, 3}, scene::Interpolation::linear), before);
  EXPECT_NE(digest_with({2, 3 + 1e-12}, scene::Interpolation::linear), before);
  EXPECT_NE(digest_with({2, 3}, scene::Interpolation::step), before);
}

TEST(CheckpointDigest, TellsWhetherALineWithInertiaHasChanged) {
  engine::SimulationSpec spec;
  spec.lines = {{.name = "1",
                 .kind = engine::LineSpec::Kind::mooring,
                 .length = 90,
                 .inertia = engine::LineInertia{.mass = 20}}};
  const std::string before = app::digest_of(spec);
  EXPECT_EQ(app::digest_of(spec), before);
  spec.lines[0].inertia->mass *= 1 + 1e-12;
  EXPECT_NE(app::digest_of(spec), before);
  spec.lines[0].inertia->mass = 20;
  spec.lines[0].inertia->segments = 19;
  EXPECT_NE(app::digest_of(spec), before);
  spec.lines[0].inertia->segments = 20;
  spec.lines[0].second.at.z() = -50;
  EXPECT_NE(app::digest_of(spec), before);
}

}  // namespace
