#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace engine {

/// A joint's reaction, found by the constraint solver.
struct JointReaction {
  std::size_t joint = 0;
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();   ///< On the second body [N].
  Eigen::Vector3d moment_W = Eigen::Vector3d::Zero();  ///< About `about_W` [N m].
  Eigen::Vector3d about_W = Eigen::Vector3d::Zero();   ///< [m]
  Eigen::Vector3d place_W = Eigen::Vector3d::Zero();   ///< Place of the joint [m].
};

}  // namespace engine
