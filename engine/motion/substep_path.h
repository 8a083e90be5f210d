#pragma once

#include <Eigen/Core>

#include "hydro/spatial.h"

namespace engine {

/// The poses of a body at about the end of a substep, where it has the mean acceleration of the
/// substep.
class SubstepPath {
 public:
  /// @param h   Length of the substep that has led from `before` to `after` [s].
  SubstepPath(const hydro::BodyState& before, const hydro::BodyState& after, double h);

  /// The state at a time after the end [s], negative before it, with the velocity of the end.
  hydro::BodyState at(double time) const;

 private:
  hydro::BodyState end_;
  Eigen::Vector3d acceleration_;  ///< [m/s^2]
  Eigen::Vector3d turning_;       ///< Angular acceleration [rad/s^2].
};

}  // namespace engine
