#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "app/pictures/pressure_range.h"
#include "app/scene/reader.h"
#include "hydro/airy_waves.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/tolerance.h"

namespace {

scene::Render read_render(const std::string& pressure) {
  const std::string text = "plimsoll: 1\nduration: 0\nrender: {pressure: " + pressure + "}\n";
  return *scene::parse(text, "scene.yaml", {}).render;
}

TEST(PressureScale, HasTheColorsThatTheSceneNames) {
  for (const auto& [name, map] : render::color_maps()) {
    const scene::Render look = read_render("{colors: " + name + "}");
    EXPECT_EQ(app::pressure_scale(look, app::PressureRange{}).colors, map) << name;
  }
}

TEST(PressureScale, ShowsThePartOfThePressureThatTheSceneNames) {
  using render::Pressure;
  const std::pair<std::string, Pressure> parts[] = {{"total", Pressure::total},
                                                    {"hydrostatic", Pressure::hydrostatic},
                                                    {"dynamic", Pressure::dynamic}};
  for (const auto& [name, part] : parts) {
    const scene::Render look = read_render("{shows: " + name + "}");
    EXPECT_EQ(app::pressure_scale(look, app::PressureRange{}).shows, part) << name;
  }
}

/// A box at rest in a steep wave, in an arbitrary pose.
engine::SimulationSpec box_in_a_wave() {
  engine::SimulationSpec spec;
  spec.sea = hydro::Sea{.density = 1025, .level = 0.4, .depth = 7, .current = {0.5, 0.2, 0}};
  spec.sea->surface =
      hydro::WaveSurface{{hydro::linear_wave(*spec.sea, 0.6, 2 * M_PI / 9, 0.8, 0.5)}};
  spec.bodies.push_back({.name = "box", .mesh_B = hydro::make_box({2, 3, 4})});
  return spec;
}

const app::Shot kShot{.time = 1.3,
                      .states = {{.position = {1, 2, -1},
                                  .orientation = Eigen::Quaterniond(Eigen::AngleAxisd(
                                      0.7, Eigen::Vector3d(1, 2, 3).normalized())),
                                  .linear_velocity = {0.5, 0.2, 0}}}};

/// Largest value at the box's corners below the surface.
template <class Quantity>
double largest_at_corners(const engine::SimulationSpec& spec, Quantity&& quantity) {
  const hydro::BodyState& state = kShot.states[0];
  double largest = 0;
  for (const auto& corner : spec.bodies[0].mesh_B.vertices.colwise()) {
    const Eigen::Vector3d p_W = state.position + state.orientation * corner;
    if (hydro::surface_height(*spec.sea, p_W.x(), p_W.y(), kShot.time) > p_W.z())
      largest = std::max(largest, quantity(p_W));
  }
  return largest;
}

TEST(PressureRange, InWavesIsThatOfTheWaterAtTheCorners) {
  engine::SimulationSpec spec = box_in_a_wave();
  const hydro::Sea& sea = *spec.sea;
  const auto weight = [&](const Eigen::Vector3d& p_W) {
    return sea.density * sea.gravity * hydro::water_at(sea, p_W, kShot.time).head;
  };
  const auto shown = [&] {
    return app::pressure_range(spec, kShot, scene::ShownPressure::hydrostatic).highest;
  };
  const double in_waves = shown();
  EXPECT_NEAR(in_waves, largest_at_corners(spec, weight), support::tolerance(1e-8));
  std::get<hydro::WaveSurface>(spec.sea->surface).kinematics = hydro::Kinematics::hydrostatic;
  EXPECT_NEAR(shown(), largest_at_corners(spec, weight), support::tolerance(1e-8));
  EXPECT_GT(std::abs(shown() - in_waves), 500);
}

TEST(PressureRange, OfDragIsZeroForABodyThatDriftsWhereTheWaterIsStill) {
  engine::SimulationSpec spec = box_in_a_wave();
  const auto dynamic = [&] {
    return app::pressure_range(spec, kShot, scene::ShownPressure::dynamic).highest;
  };
  EXPECT_GT(dynamic(), 10);
  std::get<hydro::WaveSurface>(spec.sea->surface).kinematics = hydro::Kinematics::hydrostatic;
  EXPECT_EQ(dynamic(), 0);
}

}  // namespace
