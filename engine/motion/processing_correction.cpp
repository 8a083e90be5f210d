#include "engine/motion/processing_correction.h"

#include "engine/base/constants.h"

namespace engine {

bool shows_trend(const Body& body, const Motion& motion) {
  return !body.held() && (body.wet || body.reduced_joint) && !body.dynamic_line &&
         !motion.constrained;
}

std::optional<ProcessingCorrection> find_correction(const Body& body, const Motion& motion,
                                                    double h) {
  if (!shows_trend(body, motion) || !motion.accelerations.resolved()) return std::nullopt;
  const AccelerationHistory::Trend trend = motion.accelerations.trend();
  const Eigen::Matrix3d R_WB = motion.state.orientation.toRotationMatrix();
  const Eigen::Vector3d spin = motion.state.angular_velocity;
  if (spin.norm() * h > kLargestTrendTurn) return std::nullopt;
  const Vector6d a = rotate(R_WB, trend.value);
  const Vector6d turning = to_vector6(spin.cross(a.head<3>()), spin.cross(a.tail<3>()));
  return ProcessingCorrection{.pose = h * h / 24 * a,
                              .velocity = -h * h / 24 * (rotate(R_WB, trend.slope) + turning)};
}

void correct(const Body& body, const ProcessingCorrection& correction, double sign,
             Motion& motion) {
  motion.state = displaced(body, motion.state, sign * correction.pose);
  motion.state.linear_velocity += sign * correction.velocity.head<3>();
  motion.state.angular_velocity += sign * correction.velocity.tail<3>();
  if (body.reduced_joint) motion.state = project_onto_joint(*body.reduced_joint, motion.state);
}

}  // namespace engine
