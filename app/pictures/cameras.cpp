#include "app/pictures/cameras.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

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

/// Part of the picture's height that a ball around all bodies fills.
constexpr double kFilled = 0.55;

/// Least horizontal part of a view, over its length; the camera cannot look along the vertical.
constexpr double kLeastSideways = 1e-3;

/// Returns the box around all bodies at their start, whichever way they turn.
Eigen::AlignedBox3d box_around(const engine::SimulationSpec& spec) {
  Eigen::AlignedBox3d box;
  for (const engine::BodySpec& body : spec.bodies) {
    if (body.mesh_B.vertices.cols() == 0) continue;
    const double radius = body.mesh_B.vertices.colwise().norm().maxCoeff();
    for (const double side : {-radius, radius})
      box.extend(body.initial.position + Vector3d::Constant(side));
  }
  return box;
}

}  // namespace

render::Camera camera_at_start(const scene::Camera& camera, const engine::SimulationSpec& spec) {
  const render::Camera usual;
  render::Camera placed{.from = camera.from.value_or(usual.from),
                        .to = camera.to.value_or(usual.to),
                        .field_of_view = camera.field_of_view};
  const Eigen::AlignedBox3d box = box_around(spec);
  if (box.isEmpty() || (camera.from && camera.to)) return placed;
  const Vector3d direction = usual.from.normalized();
  if (!camera.to) placed.to = box.center();
  if (!camera.from) {
    const double radius = box.sizes().norm() / 2 + (placed.to - box.center()).norm();
    placed.from = placed.to + radius / (kFilled * std::tan(camera.field_of_view / 2)) * direction;
  }
  const Vector3d view = placed.to - placed.from;
  if (view.head<2>().norm() <= kLeastSideways * view.norm()) placed.to = placed.from - direction;
  return placed;
}

std::vector<scene::Camera> cameras_of(const scene::Render& render) {
  if (render.cameras.empty()) return {render.camera};
  std::vector<scene::Camera> cameras = render.cameras;
  if (cameras.size() == 1) cameras.front().name.clear();
  return cameras;
}

render::Camera camera_at(const scene::Camera& camera, const engine::SimulationSpec& spec,
                         const Shot& shot) {
  const render::Camera start = camera_at_start(camera, spec);
  const Vector3d to = start.to + displacement(camera, spec, shot);
  const Eigen::AngleAxisd turn(camera.orbit * shot.time, Vector3d::UnitZ());
  return {
      .from = to + turn * (start.from - start.to), .to = to, .field_of_view = start.field_of_view};
}

}  // namespace app
