#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

/// @file
/// Points whose motion or water is logged.

namespace scene {

/// A point whose motion or whose water is logged: an entry of `log.probes`.
struct Probe {
  std::string name;  ///< Unique name.
  /// Exactly one of these two is given.
  std::optional<Eigen::Vector2d> wave;  ///< Place of a wave gauge, x and y in W [m].
  std::optional<std::string> body;      ///< Name of the body that carries the point.
  std::optional<double> depth;  ///< Depth of a gauge's point below the still water [m], >= 0.
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< Point of the body in its mesh frame [m].
};

}  // namespace scene
