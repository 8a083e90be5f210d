#include "engine/vertical_extent.h"

namespace engine {
namespace {

/// Third row of the rotation matrix.
Eigen::Vector3d up_in_body(const Eigen::Quaterniond& q) {
  return {2 * (q.x() * q.z() - q.w() * q.y()), 2 * (q.y() * q.z() + q.w() * q.x()),
          1 - 2 * (q.x() * q.x() + q.y() * q.y())};
}

}  // namespace

double lowest_point(const Eigen::AlignedBox3d& box_B, const hydro::BodyState& state) {
  return vertical_extent(box_B, state).lowest;
}

VerticalExtent vertical_extent(const Eigen::AlignedBox3d& box_B, const hydro::BodyState& state) {
  const Eigen::Vector3d up_B = up_in_body(state.orientation);
  const double center = state.position.z() + up_B.dot(box_B.center());
  const double height = up_B.cwiseAbs().dot(box_B.sizes());
  return {.lowest = center - height / 2, .height = height};
}

}  // namespace engine
