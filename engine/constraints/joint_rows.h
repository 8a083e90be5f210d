#pragma once

#include <vector>

#include "engine/constraints/constraint_block.h"
#include "engine/motion/joint_frames.h"

/// @file
/// The rows of ball joints, hinges, sliders, fixed and universal joints.
///
/// The rows of a joint ask for the displacements δ that take back what has come between the points
/// and axes of its two bodies (joint_frames.h),
///
///     J δ = −e,                                                                         (E38)
///
/// e being the separation of the points, along two normals of the axis for a slider, or the turn
/// between the axes or bodies. J u is the rate of e.

namespace engine {

/// The separation of the two sides of a joint, without the motion that it leaves free.
struct JointGap {
  double separation = 0;  ///< Distance of its points, on a slider across the axis [m].
  double turn = 0;        ///< Between its axes or bodies; 0 for a ball joint [rad].
};
/// @param first, second   States of its bodies, of W for kWorld.
JointGap gap_of(const JointFrames& joint, const hydro::BodyState& first,
                const hydro::BodyState& second);

/// The impulse on the joint's second body, with its moment about the centre of mass of `seen_by()`,
/// in W. The joint's blocks begin at `next`, which becomes the index after them.
Vector6d joint_impulse(const JointFrames& joint, const std::vector<ConstraintBlock>& blocks,
                       const std::vector<Eigen::Vector3d>& impulses, std::size_t& next);

/// Adds the blocks of a joint in a state. @param first, second   States of the joint's bodies; W's
/// for kWorld.
void add_joint_blocks(const JointFrames& joint, const hydro::BodyState& first,
                      const hydro::BodyState& second, std::vector<ConstraintBlock>& blocks);

}  // namespace engine
