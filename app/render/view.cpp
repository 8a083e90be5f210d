#include "app/render/view.h"

#include <Eigen/Geometry>
#include <cmath>

namespace render {
namespace {

/// Distances of the near and far planes, relative to that of the point looked at. Near this point
/// depth in single precision resolves 3e-6 of its distance.
constexpr double kNear = 0.02;
constexpr double kFar = 5000;

Eigen::Matrix4d clip_from_eye(const View& v) {
  Eigen::Matrix4d rotation = Eigen::Matrix4d::Identity();
  rotation.block<1, 3>(0, 0) = v.right_W.transpose();
  rotation.block<1, 3>(1, 0) = v.up_W.transpose();
  rotation.block<1, 3>(2, 0) = -v.forward_W.transpose();
  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  projection(0, 0) = 1 / v.half_width;
  projection(1, 1) = 1 / v.half_height;
  projection(2, 2) = -(v.far + v.near) / (v.far - v.near);
  projection(2, 3) = -2 * v.far * v.near / (v.far - v.near);
  projection(3, 2) = -1;
  return projection * rotation;
}

/// Returns the direction to the right of a gaze, unit.
Eigen::Vector3d right_of(const Eigen::Vector3d& forward, const Eigen::Vector3d& up) {
  const Eigen::Vector3d right = forward.cross(up);
  return right.norm() < 1e-6 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d(right.normalized());
}

/// Returns the largest of 1, 2, 5 times a power of ten that is at most `length`.
double round_length(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double factor : {5.0, 2.0})
    if (length >= factor * power) return factor * power;
  return power;
}

}  // namespace

double grid_length(const View& view) { return round_length(0.25 * picture_size(view)); }

Eigen::Vector3d key_light(const View& view) {
  const Eigen::Vector3d level = Eigen::Vector3d::UnitZ().cross(view.level_W);
  return (-0.55 * view.level_W - 0.5 * level + 0.75 * Eigen::Vector3d::UnitZ()).normalized();
}

View make_view(const Camera& camera, int width, int height) {
  View v;
  v.eye_W = camera.from;
  const Eigen::Vector3d gaze = camera.to - camera.from;
  v.distance = gaze.norm() > 0 ? gaze.norm() : 1;
  v.forward_W = gaze.norm() > 0 ? Eigen::Vector3d(gaze.normalized()) : Eigen::Vector3d::UnitY();
  v.right_W = right_of(v.forward_W, camera.up);
  v.level_W = right_of(v.forward_W, Eigen::Vector3d::UnitZ());
  v.up_W = v.right_W.cross(v.forward_W).normalized();
  v.half_height = std::tan(camera.field_of_view / 2);
  v.half_width = v.half_height * width / height;
  v.near = kNear * v.distance;
  v.far = kFar * v.distance;
  v.clip_from_E = clip_from_eye(v);
  return v;
}

}  // namespace render
