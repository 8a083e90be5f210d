#pragma once

#include <Eigen/Core>

namespace hydro {

/// Heights of water over a part of the sea.
struct SurfacePatch {
  Eigen::MatrixXf heights;  ///< Above the given sea [m]; rows along y, columns along x.
  double cell = 1;          ///< Distance of neighbouring heights [m].
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< Place of heights(0, 0) in W [m].

  /// The height over a point, by cubic interpolation; 0 outside [m].
  double at(double x, double y) const;

  bool operator==(const SurfacePatch&) const = default;
};

}  // namespace hydro
