#pragma once

#include <Eigen/Core>

#include "engine/base/spec.h"

/// @file
/// Places of slack lines in pictures.

namespace app {

/// Returns points of a line that hangs between two points, from the first to the second [m, W]: a
/// catenary of the given length. A line that is no longer than the distance of its ends is straight
/// and has two points. The length along the points falls short of `length` by less than 1e-3 of it.
Eigen::Matrix3Xd hanging_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                              double length);

/// Height of the ground.
class GroundHeight {
 public:
  /// @param ground   It must outlive the object.
  explicit GroundHeight(const engine::Ground& ground);

  /// Returns z of the highest ground at a place [m]; −∞ where there is none.
  double at(double x, double y) const;

  /// Raises points to `clearance` above the ground [m].
  void lift(Eigen::Matrix3Xd& points_W, double clearance) const;

 private:
  const engine::Ground& ground_;
  double highest_;  ///< z of the highest ground anywhere.
};

}  // namespace app
