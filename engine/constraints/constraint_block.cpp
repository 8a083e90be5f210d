#include "engine/constraints/constraint_block.h"

#include <Eigen/Geometry>
#include <cmath>

#include "engine/base/constants.h"

namespace engine {

using Eigen::Vector3d;

namespace {

/// The row of the velocity of a point along a direction.
Eigen::Matrix<double, 1, 6> along(const Vector3d& direction, const Vector3d& arm) {
  return to_vector6(direction, arm.cross(direction)).transpose();
}

}  // namespace

ConstraintBlock contact_block(const Contact& contact, const Vector3d& first, const Vector3d& second,
                              double h) {
  const ContactPoint& point = contact.point;
  const bool bounces = contact.rebounds && contact.restitution > 0;
  ConstraintBlock block{.kind = ConstraintBlock::Kind::contact,
                        .bodies = {contact.pair.first, contact.pair.second},
                        .give = bounces ? 0 : kContactCompliance,
                        .limit = contact.friction};
  const Vector3d& normal = point.normal_W;
  const Vector3d tangent = normal.unitOrthogonal();
  const Vector3d axes[] = {normal, tangent, normal.cross(tangent)};
  for (int i = 0; i < 3; ++i) {
    block.J[0].row(i) = along(axes[i], point.position_W - first);
    block.J[1].row(i) = -along(axes[i], point.position_W - second);
  }
  block.target[0] = contact.row.speed;
  block.compliance = Vector3d::Constant(contact.row.compliance / h);
  return block;
}

ConstraintBlock force_block(const ForceRow& row, const Vector3d& first, const Vector3d& second,
                            double h) {
  using Kind = ConstraintBlock::Kind;
  const bool bounded = std::isfinite(row.largest_force);
  ConstraintBlock block{.kind = row.one_sided ? Kind::one_sided
                                : bounded     ? Kind::bounded
                                              : Kind::bilateral,
                        .rows = 1,
                        .bodies = {row.first, row.second},
                        .limit = bounded ? h * row.largest_force : 0};
  for (const auto& [side, sign, center] : {std::tuple(0, -1, first), std::tuple(1, 1, second)})
    block.J[side].row(0) =
        sign * (row.turns ? to_vector6(Vector3d::Zero(), row.direction_W).transpose()
                          : along(row.direction_W, row.point_W - center));
  block.target[0] = row.target;
  block.compliance[0] = row.compliance / h;
  return block;
}

}  // namespace engine
