#include "hydro/loads/kernel/shear.h"

#include <algorithm>

#include "hydro/loads/refine.h"

namespace hydro::kernel {

bool Shear::straight(double low, double high) const {
  return std::none_of(bends.begin(), bends.end(), [&](double z) { return z > low && z < high; });
}

Shear make_shear(const Sea& sea, const Eigen::Vector3d& p_WB, const Eigen::Matrix3d& R_WB,
                 double radius) {
  Shear shear;
  if (sea.profile.empty()) return shear;
  const double reach = 2 * radius;  // The corners of a branch's box may stick out of the sphere.
  const double level = sea.level - p_WB.z();
  const auto in_body = [&](const Eigen::Vector2d& v) -> Eigen::Vector3d {
    return R_WB.transpose() * Eigen::Vector3d(v.x(), v.y(), 0);
  };
  shear.moves = true;
  Eigen::Vector2d first = sea.profile.front().velocity;
  for (std::size_t i = 0; i < sea.profile.size(); ++i) {
    const CurrentRow& row = sea.profile[i];
    const double top = level - row.depth;
    shear.fastest = std::max(shear.fastest, (row.velocity - sea.current.head<2>()).norm());
    if (i + 1 == sea.profile.size()) break;
    const CurrentRow& next = sea.profile[i + 1];
    const double bottom = level - next.depth;
    if (bottom >= reach) first = next.velocity;
    if (bottom >= reach || top <= -reach) continue;
    const Eigen::Vector3d change = in_body(next.velocity - row.velocity);
    shear.layers.push_back(
        {top, 1 / (next.depth - row.depth), {change.x(), change.y(), change.z()}});
  }
  Eigen::Map<Eigen::Vector3d>(shear.first) = in_body(first) - R_WB.transpose() * sea.current;
  shear.bends = bends_of_current(sea, p_WB.z(), reach);
  return shear;
}

}  // namespace hydro::kernel
