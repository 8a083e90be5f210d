#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "app/pictures/expected_pressure.h"
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
    EXPECT_EQ(app::pressure_scale(look, {}, {}).colors, map) << name;
  }
}

TEST(PressureScale, ShowsThePartOfThePressureThatTheSceneNames) {
  using render::Pressure;
  const std::pair<std::string, Pressure> parts[] = {{"total", Pressure::total},
                                                    {"hydrostatic", Pressure::hydrostatic},
                                                    {"dynamic", Pressure::dynamic}};
  for (const auto& [name, part] : parts) {
    const scene::Render look = read_render("{shows: " + name + "}");
    EXPECT_EQ(app::pressure_scale(look, {}, {}).shows, part) << name;
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

/// The scale of a scene for expected and drawn pressures [Pa].
render::PressureScale scale_of(const std::string& pressure, app::PressureRange expected,
                               app::PressureRange drawn) {
  return app::pressure_scale(read_render(pressure), expected, drawn);
}

TEST(PressureScale, IsFoundFromTheSceneUnlessItsEndsAreGivenOrDrawn) {
  const app::PressureRange expected{-700, 5300}, drawn{-90, 2100};
  const auto ends = [&](const std::string& pressure) {
    const render::PressureScale scale = scale_of(pressure, expected, drawn);
    return std::pair(scale.min, scale.max);
  };
  EXPECT_EQ(ends("{}"), std::pair(0.0, 6000.0));
  EXPECT_EQ(ends("{min: auto}"), std::pair(-800.0, 6000.0));
  EXPECT_EQ(ends("{min: drawn, max: drawn}"), std::pair(-100.0, 2500.0));
  EXPECT_EQ(ends("{min: -5, max: 1234}"), std::pair(-5.0, 1234.0));
}

TEST(PressureScale, ThatDivergesHasZeroInItsMiddleUnlessBothEndsAreGiven) {
  const app::PressureRange expected{-3100, 900};
  const auto ends = [&](const std::string& pressure) {
    const render::PressureScale scale = scale_of(pressure, expected, expected);
    return std::pair(scale.min, scale.max);
  };
  EXPECT_EQ(ends("{shows: dynamic}"), std::pair(-4000.0, 4000.0));
  EXPECT_EQ(ends("{colors: coolwarm}"), std::pair(-4000.0, 4000.0));
  EXPECT_EQ(ends("{colors: coolwarm, max: 700}"), std::pair(-700.0, 700.0));
  EXPECT_EQ(ends("{colors: coolwarm, min: -300}"), std::pair(-300.0, 300.0));
  EXPECT_EQ(ends("{colors: coolwarm, min: -100, max: 700}"), std::pair(-100.0, 700.0));
  EXPECT_EQ(ends("{shows: dynamic, colors: turbo}"), std::pair(-4000.0, 1000.0));
}

TEST(PressureScale, TellsWhetherPicturesGoBeyondIt) {
  const auto beyond = [](double lowest, double highest) {
    const render::PressureScale scale = scale_of("{max: 1000}", {}, {lowest, highest});
    return std::pair(scale.below, scale.above);
  };
  EXPECT_EQ(beyond(0, 1000), std::pair(false, false));
  EXPECT_EQ(beyond(-1, 1001), std::pair(false, false));  // less than can be seen
  EXPECT_EQ(beyond(-10, 500), std::pair(true, false));
  EXPECT_EQ(beyond(0, 1010), std::pair(false, true));
}

/// The highest pressure to expect [m of water] of a box of 2 m, whose middle is at height z.
double expected_head(double mass, double z, const engine::Ground& ground = {}) {
  engine::SimulationSpec spec;
  spec.sea = hydro::Sea{};
  spec.ground = ground;
  spec.bodies.push_back({.name = "box", .mesh_B = hydro::make_box({2, 2, 2}), .mass = mass});
  spec.bodies[0].initial.position.z() = z;
  return app::expected_pressure(spec, scene::ShownPressure::hydrostatic).highest /
         (spec.sea->density * spec.sea->gravity);
}

TEST(ExpectedPressure, IsThatOfTheDepthToWhichABodyGoes) {
  const double density = hydro::Sea{}.density, tolerance = support::tolerance(1e-6);
  EXPECT_NEAR(expected_head(density * 2, 0.9), 0.5, tolerance);  // floats to 2 / 4 m
  EXPECT_NEAR(expected_head(density * 2, -3), 4, tolerance);     // rises from there
  EXPECT_NEAR(expected_head(density * 2, 5), 2, tolerance);      // falls in
  EXPECT_NEAR(expected_head(density * 9, 0), 4, tolerance);      // sinks, who knows how far
  EXPECT_NEAR(expected_head(density * 9, 0, engine::PlaneGround{-7}), 7, tolerance);
}

TEST(ExpectedPressure, OfWavesAddsTheirHeight) {
  engine::SimulationSpec spec = box_in_a_wave();
  spec.bodies[0].locked.fill(true);
  spec.bodies[0].initial.position = {0, 0, spec.sea->level};
  const double head = app::expected_pressure(spec, scene::ShownPressure::hydrostatic).highest /
                      (spec.sea->density * spec.sea->gravity);
  EXPECT_NEAR(head, 2 + 0.6 * std::sqrt(2), support::tolerance(1e-9));
}

TEST(ExpectedPressure, OfAFallIsThatOfItsSpeed) {
  engine::SimulationSpec spec;
  spec.sea = hydro::Sea{};
  spec.bodies.push_back({.name = "box", .mesh_B = hydro::make_box({2, 2, 2}), .mass = 100});
  spec.bodies[0].initial.position.z() = 11;
  const app::PressureRange range = app::expected_pressure(spec, scene::ShownPressure::dynamic);
  const double head = spec.sea->density * spec.sea->gravity * 10;
  EXPECT_NEAR(range.highest, spec.bodies[0].coefficients.pressure_drag.front * head, 1e-6 * head);
  EXPECT_NEAR(range.lowest, -spec.bodies[0].coefficients.pressure_drag.back * head, 1e-6 * head);
}

}  // namespace
