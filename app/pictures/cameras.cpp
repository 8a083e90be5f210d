#include "app/pictures/cameras.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>

namespace app {
namespace {

using Eigen::Vector3d;

/// Displacement from its start of the body that the camera follows [m, W].
Vector3d displacement(const scene::Camera& camera, const engine::SimulationSpec& spec,
                      const Shot& shot) {
  if (camera.follow.empty()) return Vector3d::Zero();
  const auto body =
      std::find_if(spec.bodies.begin(), spec.bodies.end(),
                   [&](const engine::BodySpec& b) { return b.name == camera.follow; });
  assert(body != spec.bodies.end());
  const auto index = static_cast<std::size_t>(body - spec.bodies.begin());
  return shot.states[index].position - body->initial.position;
}

}  // namespace

std::vector<scene::Camera> cameras_of(const scene::Render& render) {
  if (render.cameras.empty()) return {render.camera};
  std::vector<scene::Camera> cameras = render.cameras;
  if (cameras.size() == 1) cameras.front().name.clear();
  return cameras;
}

render::Camera camera_at(const scene::Camera& camera, const engine::SimulationSpec& spec,
                         const Shot& shot) {
  const Vector3d to = camera.to + displacement(camera, spec, shot);
  const Eigen::AngleAxisd turn(camera.orbit * shot.time, Vector3d::UnitZ());
  return {.from = to + turn * (camera.from - camera.to),
          .to = to,
          .field_of_view = camera.field_of_view};
}

}  // namespace app
