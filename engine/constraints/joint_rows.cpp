#include "engine/constraints/joint_rows.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace engine {
namespace {

using Eigen::Vector3d;
using Kind = ConstraintBlock::Kind;
using Type = JointSpec::Type;

/// Rows of the separation of two points, or of a turn, along some directions.
struct Rows {
  std::vector<Vector3d> directions;
  Vector3d apart;  ///< Separation or turn of the first body from the second, to be closed.
};

void add_separation(const JointFrames& joint, const Rows& rows, const Vector3d& first_arm,
                    const Vector3d& second_arm, std::vector<ConstraintBlock>& blocks) {
  ConstraintBlock block{.rows = static_cast<int>(rows.directions.size()), .bodies = joint.bodies};
  for (int i = 0; i < block.rows; ++i) {
    const Vector3d& e = rows.directions[static_cast<std::size_t>(i)];
    block.J[0].row(i) = to_vector6(e, first_arm.cross(e)).transpose();
    block.J[1].row(i) = -to_vector6(e, second_arm.cross(e)).transpose();
    block.target[i] = -e.dot(rows.apart);
  }
  blocks.push_back(block);
}

void add_turn(const JointFrames& joint, const Rows& rows, std::vector<ConstraintBlock>& blocks) {
  ConstraintBlock block{.rows = static_cast<int>(rows.directions.size()), .bodies = joint.bodies};
  for (int i = 0; i < block.rows; ++i) {
    const Vector3d& e = rows.directions[static_cast<std::size_t>(i)];
    block.J[0].row(i) = to_vector6(Vector3d::Zero(), e).transpose();
    block.J[1].row(i) = -block.J[0].row(i);
    block.target[i] = -e.dot(rows.apart);
  }
  blocks.push_back(block);
}

std::vector<Vector3d> all_directions() {
  return {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()};
}

std::vector<Vector3d> normals(const Vector3d& axis) {
  const Vector3d normal = axis.unitOrthogonal();
  return {normal, axis.cross(normal)};
}

/// The turn as axis times angle, the angle at most π.
Vector3d turn_vector(const Eigen::Quaterniond& turn) {
  const Eigen::AngleAxisd whole(turn);
  return whole.angle() * whole.axis();
}

/// The turn that takes one unit vector to another, as axis times angle.
Vector3d turn_between(const Vector3d& from, const Vector3d& to) {
  const Vector3d normal = from.cross(to);
  const double sine = normal.norm();
  return sine > 0 ? Vector3d(std::atan2(sine, from.dot(to)) / sine * normal) : normal;
}

/// A joint in a state, in W.
struct PlacedJoint {
  std::array<Vector3d, 2> arms;  ///< From the centres of mass to its points [m].
  std::array<Vector3d, 2> axes;
  Vector3d apart;            ///< The first body's point from the second's [m].
  Eigen::Quaterniond ahead;  ///< Turn of the first body from where the second one is.
};

PlacedJoint placed(const JointFrames& joint, const hydro::BodyState& first,
                   const hydro::BodyState& second) {
  PlacedJoint p{.arms = {first.orientation * joint.points[0], second.orientation * joint.points[1]},
                .axes = {first.orientation * joint.axes[0], second.orientation * joint.axes[1]},
                .apart = {},
                .ahead = first.orientation * joint.turn * second.orientation.conjugate()};
  p.apart = first.position + p.arms[0] - second.position - p.arms[1];
  return p;
}

}  // namespace

JointGap gap_of(const JointFrames& joint, const hydro::BodyState& first,
                const hydro::BodyState& second) {
  const PlacedJoint p = placed(joint, first, second);
  const Vector3d& axis = p.axes[0];
  JointGap gap{.separation = p.apart.norm()};
  switch (joint.type) {
    case Type::ball:
      break;
    case Type::hinge:
      gap.turn = turn_between(axis, p.axes[1]).norm();
      break;
    case Type::universal:
      gap.turn = std::abs(std::asin(std::clamp(axis.dot(p.axes[1]), -1.0, 1.0)));
      break;
    case Type::slider:
      gap.separation = (p.apart - p.apart.dot(axis) * axis).norm();
      gap.turn = turn_vector(p.ahead).norm();
      break;
    case Type::fixed:
      gap.turn = turn_vector(p.ahead).norm();
      break;
  }
  return gap;
}

Vector6d joint_impulse(const JointFrames& joint, const std::vector<ConstraintBlock>& blocks,
                       const std::vector<Vector3d>& impulses, std::size_t& next) {
  // The force on the second body is opposite to that on the first.
  const bool on_first = joint.seen_by() == joint.bodies[0];
  Vector6d sum = Vector6d::Zero();
  for (int i = 0; i < joint.blocks(); ++i, ++next)
    sum += (on_first ? -1 : 1) * blocks[next].J[on_first ? 0 : 1].transpose() * impulses[next];
  return sum;
}

void add_joint_blocks(const JointFrames& joint, const hydro::BodyState& first,
                      const hydro::BodyState& second, std::vector<ConstraintBlock>& blocks) {
  const auto [arms, axes, apart, ahead] = placed(joint, first, second);
  if (joint.type == Type::slider) {
    // The second body's point is where the first one's would be, slid along the axis.
    const Vector3d at = second.position + arms[1];
    add_separation(joint, {normals(axes[0]), apart}, at - first.position, arms[1], blocks);
  } else {
    add_separation(joint, {all_directions(), apart}, arms[0], arms[1], blocks);
  }
  switch (joint.type) {
    case Type::ball:
      break;
    case Type::hinge:
      add_turn(joint, {normals(axes[0]), turn_between(axes[1], axes[0])}, blocks);
      break;
    case Type::universal: {
      const Vector3d normal = axes[0].cross(axes[1]).normalized();
      add_turn(joint, {{normal}, axes[0].dot(axes[1]) * normal}, blocks);
      break;
    }
    case Type::slider:
    case Type::fixed:
      add_turn(joint, {all_directions(), turn_vector(ahead)}, blocks);
  }
}

}  // namespace engine
