#include "app/pictures/cameras.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace app {
namespace {

using Eigen::Vector3d;

/// Index of a body by its name, which the scene's reader has found to be one.
std::size_t index_of(const std::string& name, const engine::SimulationSpec& spec) {
  const auto body = std::find_if(spec.bodies.begin(), spec.bodies.end(),
                                 [&](const engine::BodySpec& b) { return b.name == name; });
  assert(body != spec.bodies.end());
  return static_cast<std::size_t>(body - spec.bodies.begin());
}

/// Displacement from its start of the body that the camera follows [m, W].
Vector3d displacement(const scene::Camera& camera, const engine::SimulationSpec& spec,
                      const Shot& shot) {
  if (camera.follow.empty()) return Vector3d::Zero();
  const std::size_t index = index_of(camera.follow, spec);
  return shot.states[index].position - spec.bodies[index].initial.position;
}

/// Returns in W a camera that is given in the mesh frame M of a body, with the body's z up.
render::Camera on_body(const render::Camera& camera_M, const Vector3d& com_M,
                       const hydro::BodyState& state) {
  const auto in_W = [&](const Vector3d& p_M) -> Vector3d {
    return state.position + state.orientation * (p_M - com_M);
  };
  return {.from = in_W(camera_M.from),
          .to = in_W(camera_M.to),
          .field_of_view = camera_M.field_of_view,
          .up = state.orientation * camera_M.up};
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

/// Returns a camera at time 0, in W or in the mesh frame of the body that it is on.
render::Camera placed_camera(const scene::Camera& camera, const engine::SimulationSpec& spec) {
  const render::Camera usual;
  render::Camera placed{.from = camera.from.value_or(usual.from),
                        .to = camera.to.value_or(usual.to),
                        .field_of_view = camera.field_of_view};
  if (camera.from && camera.to) return placed;
  const Eigen::AlignedBox3d box = box_around(spec);
  if (box.isEmpty()) return placed;
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

}  // namespace

render::Camera camera_at_start(const scene::Camera& camera, const assembly::BuiltScene& built) {
  const render::Camera placed = placed_camera(camera, built.spec);
  if (camera.on.empty()) return placed;
  const std::size_t body = index_of(camera.on, built.spec);
  return on_body(placed, built.centers_of_mass[body], built.spec.bodies[body].initial);
}

std::vector<scene::Camera> cameras_of(const scene::Render& render) {
  if (render.cameras.empty()) return {render.camera};
  std::vector<scene::Camera> cameras = render.cameras;
  if (cameras.size() == 1) cameras.front().name.clear();
  return cameras;
}

render::Camera camera_at(const scene::Camera& camera, const assembly::BuiltScene& built,
                         const Shot& shot) {
  const render::Camera start = placed_camera(camera, built.spec);
  const Vector3d to = start.to + displacement(camera, built.spec, shot);
  const Eigen::AngleAxisd turn(camera.orbit * shot.time, Vector3d::UnitZ());
  const render::Camera moved = {
      .from = to + turn * (start.from - start.to), .to = to, .field_of_view = start.field_of_view};
  if (camera.on.empty()) return moved;
  const std::size_t body = index_of(camera.on, built.spec);
  return on_body(moved, built.centers_of_mass[body], shot.states[body]);
}

}  // namespace app
