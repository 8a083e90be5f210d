#pragma once

#include <vector>

#include "engine/constraint_block.h"
#include "engine/spec.h"

/// @file
/// The rows of ball joints, hinges, sliders, fixed and universal joints.
///
/// A joint is known by points and axes that are fixed in its two bodies and coincide at time 0. Its
/// rows ask for the velocities with which a part of what has come between them is taken back in a
/// substep of length h,
///
///     J u = −(kJointErp/h) e,                                                           (E38)
///
/// e being the separation of the points, along two normals of the axis for a slider, or the turn
/// between the axes or bodies.

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

  /// Number of blocks that add_joint_blocks() adds.
  int blocks() const { return type == JointSpec::Type::ball ? 1 : 2; }
};

/// @param bodies   kWorld for those that cannot move.
/// @param first, second   States at time 0, of W for kWorld.
JointFrames joint_frames(const JointSpec& joint, std::size_t index,
                         const std::array<BodyId, 2>& bodies, const hydro::BodyState& first,
                         const hydro::BodyState& second);

/// What has come between the two sides of a joint, without what it leaves free.
struct JointGap {
  double separation = 0;  ///< Distance of its points, on a slider across the axis [m].
  double turn = 0;        ///< Between its axes or bodies; 0 for a ball joint [rad].
};
/// @param first, second   States of its bodies, of W for kWorld.
JointGap gap_of(const JointFrames& joint, const hydro::BodyState& first,
                const hydro::BodyState& second);

/// Adds the blocks of a joint in a state. @param first, second   Of W for kWorld.
void add_joint_blocks(const JointFrames& joint, const hydro::BodyState& first,
                      const hydro::BodyState& second, double h,
                      std::vector<ConstraintBlock>& blocks);

}  // namespace engine
