#include "tests/render/pictures.h"

#include <algorithm>
#include <cmath>

#include "hydro/mesh/primitives.h"
#include "hydro/wave_spectrum.h"

namespace pictures {
namespace {

using Eigen::Vector3d;
using hydro::BodyState;
using render::BodyAppearance;
using render::SceneDescription;

constexpr double kGravity = 9.80665;

Eigen::Quaterniond turned(double degrees, const Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * M_PI / 180, axis.normalized()));
}

hydro::Sea waves(double amplitude, double wavelength, double heading) {
  hydro::Sea sea;
  sea.surface =
      hydro::WaveSurface{{hydro::deep_water_wave(amplitude, wavelength, heading, 0.3, kGravity)}};
  return sea;
}

Scene ball_in_still_water() {
  Scene s{.name = "ball", .picture = {}, .states = {BodyState{}}};
  s.picture.sea = hydro::Sea{};
  s.picture.pressure.max = 10e3;
  s.picture.camera = {.from = {3.5, -6, 2.4}, .to = {0, 0, -0.1}};
  s.picture.bodies = {{.mesh_B = hydro::make_sphere(1, 50, 50), .color = {0.8, 0.6, 0.2}}};
  return s;
}

Scene box_in_waves() {
  Scene s{.name = "box_in_waves", .picture = {}};
  s.states = {{.position = {0, 0, 0.1}, .orientation = turned(20, {1, 2, 0.5})}};
  s.picture.sea = waves(0.25, 3, 0.4);
  s.picture.pressure.max = 12e3;
  s.picture.pressure.above = true;
  s.picture.camera = {.from = {5, -8, 3.2}, .to = {0, 0, 0}};
  s.picture.bodies = {{.mesh_B = hydro::make_box({2, 2, 2}), .color = {0.85, 0.35, 0.25}}};
  return s;
}

Scene rings_at_depths() {
  Scene s{.name = "rings", .picture = {}};
  const BodyAppearance ring = {.mesh_B = make_torus(0.8, 0.3, 64, 32), .color = {0.9, 0.75, 0.3}};
  s.picture.sea = hydro::Sea{};
  s.picture.pressure.max = 20e3;
  s.picture.pressure.above = true;
  s.picture.camera = {.from = {3, -10, 3.5}, .to = {0, 0, -0.4}};
  for (int i = 0; i < 4; ++i) {
    s.picture.bodies.push_back(ring);
    s.states.push_back({.position = {-3.0 + 2 * i, 0.3 * i, 1.2 - 0.9 * i},
                        .orientation = turned(25 + 30 * i, {1, 0.3 * i, 0})});
  }
  return s;
}

Scene slamming_ball() {
  Scene s = ball_in_still_water();
  s.name = "slamming_ball";
  s.states[0].position.z() = 0.3;
  s.states[0].linear_velocity = {1, 0, -5};
  s.picture.pressure.above = true;
  s.picture.bodies[0].coefficients.pressure_drag = {0.6316, 0.6316};
  s.picture.bodies[0].color = {0.75, 0.78, 0.82};
  return s;
}

Scene ship_in_storm() {
  Scene s{.name = "storm", .picture = {}};
  s.states = {
      {.position = {0, 0, 0.5}, .orientation = turned(35, {0, 0, 1}) * turned(6, {1, 1, 0})}};
  hydro::Sea sea;
  sea.surface = hydro::jonswap_sea({.significant_height = 3, .peak_period = 7, .spreading = 4},
                                   {.gravity = kGravity});
  s.picture.sea = sea;
  s.picture.pressure.max = 40e3;
  s.picture.camera = {.from = {30, -48, 15}, .to = {0, 0, 0}};
  s.picture.bodies = {
      {.mesh_B = hydro::make_ellipsoid({12, 4, 3}, 64, 32), .color = {0.7, 0.2, 0.2}}};
  s.time = 4;
  return s;
}

Scene pool_with_floor() {
  Scene s = rings_at_depths();
  s.name = "pool";
  s.picture.ground_z = -2.5;
  s.picture.camera.from = {4, -9, 5};
  return s;
}

/// A mound under and over the water.
hydro::TriMesh make_mound() {
  constexpr int kCells = 60;
  hydro::TriMesh mesh;
  mesh.vertices.resize(3, (kCells + 1) * (kCells + 1));
  mesh.faces.resize(3, 2 * kCells * kCells);
  for (int i = 0; i <= kCells; ++i)
    for (int j = 0; j <= kCells; ++j) {
      const double x = 0.5 * (i - kCells / 2), y = 0.5 * (j - kCells / 2);
      const double height =
          3.6 * std::exp(-(x * x + y * y) / 30) - 3 + 0.15 * std::sin(2 * x) * std::cos(y);
      mesh.vertices.col(i * (kCells + 1) + j) = Vector3d(x + 3, y + 3, height);
    }
  for (int i = 0, f = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      const int v = i * (kCells + 1) + j;
      mesh.faces.col(f++) = Eigen::Vector3i(v, v + kCells + 1, v + 1);
      mesh.faces.col(f++) = Eigen::Vector3i(v + 1, v + kCells + 1, v + kCells + 2);
    }
  return mesh;
}

Scene shore() {
  Scene s = box_in_waves();
  s.name = "shore";
  s.picture.sea = waves(0.12, 4, 0.9);
  s.picture.ground_W = make_mound();
  s.picture.camera = {.from = {3, -12, 5}, .to = {1, 0, -0.3}};
  return s;
}

Scene diver() {
  Scene s = rings_at_depths();
  s.name = "diver";
  s.picture.sea = waves(0.15, 3, 1.2);
  s.picture.camera = {.from = {2, -7, -2.2}, .to = {0, 0, -0.4}};
  s.picture.ground_z = -4;
  return s;
}

Scene from_above() {
  Scene s = box_in_waves();
  s.name = "from_above";
  s.picture.camera = {.from = {0, 0, 12}, .to = {0, 0, 0}};
  return s;
}

Scene dry() {
  Scene s = rings_at_depths();
  s.name = "dry";
  s.picture.sea.reset();
  s.picture.ground_z = -2;
  return s;
}

}  // namespace

std::filesystem::path shader_folder() {
  return std::filesystem::path(PLIMSOLL_SOURCE_DIR) / "shaders";
}

std::optional<render::PressureScale> scale_of(const Scene& scene) {
  if (!scene.picture.sea) return std::nullopt;
  return scene.picture.pressure;
}

render::Image draw(const Scene& scene) {
  return render::Renderer(scene.picture, shader_folder()).draw(scene.states, scene.time);
}

Reading read_color(const render::PressureScale& scale, render::Rgb color) {
  const auto& colors = render::scale_colors(scale.colors);
  const auto apart = [&](render::Rgb c) {
    return Vector3d(c.r - color.r, c.g - color.g, c.b - color.b).norm();
  };
  const auto nearest = std::min_element(colors.begin(), colors.end(),
                                        [&](auto a, auto b) { return apart(a) < apart(b); });
  const double place = static_cast<double>(nearest - colors.begin()) / (render::kScaleColors - 1);
  return {.pressure = scale.min + (scale.max - scale.min) * place, .apart = apart(*nearest)};
}

hydro::TriMesh make_torus(double radius, double tube_radius, int around, int across) {
  hydro::TriMesh mesh;
  mesh.vertices.resize(3, around * across);
  mesh.faces.resize(3, 2 * around * across);
  for (int i = 0, f = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * j / across;
      const double r = radius + tube_radius * std::cos(v);
      mesh.vertices.col(i * across + j) << r * std::cos(u), r * std::sin(u),
          tube_radius * std::sin(v);
      const int right = (i + 1) % around * across, up = (j + 1) % across;
      mesh.faces.col(f++) = Eigen::Vector3i(i * across + j, right + j, right + up);
      mesh.faces.col(f++) = Eigen::Vector3i(i * across + j, right + up, i * across + up);
    }
  return mesh;
}

Scene ball_seen_level(double z) {
  Scene s = ball_in_still_water();
  s.picture.width = 320;
  s.picture.height = 240;
  s.picture.camera = {.from = {0, -10, 0}, .to = {0, 0, 0}, .field_of_view = 2 * std::atan(0.15)};
  s.picture.water_visible = false;
  s.states[0].position.z() = z;
  return s;
}

std::vector<Scene> gallery() {
  return {
      ball_in_still_water(), box_in_waves(), rings_at_depths(), slamming_ball(), ship_in_storm(),
      pool_with_floor(),     shore(),        diver(),           from_above(),    dry()};
}

}  // namespace pictures
