#include "app/view/orbit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/render/view.h"

namespace app {
namespace {

constexpr double kSteepest = 89 * std::numbers::pi / 180;
constexpr double kZoom = 0.85;                      // per notch
constexpr double kNearest = 1e-3, kFarthest = 1e6;  // [m]

/// Returns the axes of the picture. Points in half heights do not depend on its width.
render::View axes(const render::Camera& camera) { return render::make_view(camera, 1, 1); }

}  // namespace

Orbit orbit_of(const render::Camera& camera) {
  const Eigen::Vector3d arm = camera.from - camera.to;
  return {.to = camera.to,
          .distance = arm.norm(),
          .azimuth = std::atan2(arm.y(), arm.x()),
          .elevation = std::atan2(arm.z(), arm.head<2>().norm()),
          .field_of_view = camera.field_of_view};
}

render::Camera camera_of(const Orbit& orbit) {
  const double level = std::cos(orbit.elevation);
  const Eigen::Vector3d arm(level * std::cos(orbit.azimuth), level * std::sin(orbit.azimuth),
                            std::sin(orbit.elevation));
  return {.from = orbit.to + orbit.distance * arm,
          .to = orbit.to,
          .field_of_view = orbit.field_of_view};
}

Orbit turned(Orbit orbit, const Eigen::Vector2d& way) {
  const Eigen::Vector2d turn = std::numbers::pi / 2 * way;
  orbit.azimuth = std::remainder(orbit.azimuth - turn.x(), 2 * std::numbers::pi);
  orbit.elevation = std::clamp(orbit.elevation - turn.y(), -kSteepest, kSteepest);
  return orbit;
}

Orbit panned(Orbit orbit, const Eigen::Vector2d& way) {
  const render::View view = axes(camera_of(orbit));
  const double scale = view.half_height * orbit.distance;
  orbit.to -= scale * (way.x() * view.right_W + way.y() * view.up_W);
  return orbit;
}

Orbit zoomed(Orbit orbit, double notches) {
  orbit.distance = std::clamp(orbit.distance * std::pow(kZoom, notches), kNearest, kFarthest);
  return orbit;
}

Ray ray_through(const render::Camera& camera, const Eigen::Vector2d& point) {
  const render::View view = axes(camera);
  return {.from_W = view.eye_W,
          .along_W = view.forward_W +
                     view.half_height * (point.x() * view.right_W + point.y() * view.up_W)};
}

}  // namespace app
