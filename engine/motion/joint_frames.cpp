#include "engine/motion/joint_frames.h"

namespace engine {

JointFrames joint_frames(const JointSpec& joint, std::size_t index,
                         const std::array<BodyId, 2>& bodies, const hydro::BodyState& first,
                         const hydro::BodyState& second) {
  JointFrames frames{.index = index, .type = joint.type, .bodies = bodies};
  const bool anchored =
      joint.type != JointSpec::Type::slider && joint.type != JointSpec::Type::fixed;
  // Any point will do for a joint that keeps the bodies parallel.
  const Eigen::Vector3d point =
      anchored ? joint.anchor_W : (bodies[1] == kWorld ? first : second).position;
  const Eigen::Vector3d axes[] = {
      joint.axis_W, joint.type == JointSpec::Type::universal ? joint.axis2_W : joint.axis_W};
  const hydro::BodyState* states[] = {&first, &second};
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Quaterniond to_body = states[i]->orientation.conjugate();
    frames.points[i] = to_body * (point - states[i]->position);
    frames.axes[i] = to_body * axes[i];
  }
  frames.turn = first.orientation.conjugate() * second.orientation;
  return frames;
}

}  // namespace engine
