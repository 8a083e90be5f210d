#pragma once

#include <array>

#include "engine/base/spec.h"

/// @file
/// Joints as points and axes that are fixed in their two bodies and coincide at time 0.

namespace engine {

/// A joint between bodies. The frame of a body that cannot move is W.
struct JointFrames {
  std::size_t index = 0;  ///< In the specification.
  JointSpec::Type type = JointSpec::Type::ball;
  std::array<BodyId, 2> bodies{kWorld, kWorld};  ///< kWorld for those that cannot move.
  /// The point and the axis in each body, from its centre of mass.
  std::array<Eigen::Vector3d, 2> points{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::array<Eigen::Vector3d, 2> axes{Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ()};
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();  ///< From the second to the first.

  /// Number of blocks that add_joint_blocks() adds (joint_rows.h).
  int blocks() const { return type == JointSpec::Type::ball ? 1 : 2; }
  /// One that can move.
  BodyId seen_by() const { return bodies[bodies[0] == kWorld ? 1 : 0]; }
};

/// @param bodies   kWorld for those that cannot move.
/// @param first, second   States at time 0, of W for kWorld.
JointFrames joint_frames(const JointSpec& joint, std::size_t index,
                         const std::array<BodyId, 2>& bodies, const hydro::BodyState& first,
                         const hydro::BodyState& second);

}  // namespace engine
