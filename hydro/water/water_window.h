#pragma once

#include <Eigen/Core>
#include <vector>

#include "hydro/sea.h"
#include "hydro/water/periodic_waves.h"
#include "hydro/water/surface_patch.h"

/// @file
/// The window over a periodic square of water that rides with the current and repeats itself.
///
/// The window follows bodies over the square, whose cells are used anew at the other side of the
/// window. At the window's edges the waves are damped.

namespace hydro {

class WaterWindow {
 public:
  /// @param edge   Width of the damped edge [m]; 0: a fifth of the square's side.
  WaterWindow(const PeriodicSquare& square, const Sea& sea, double edge = 0);

  /// A place in cells of the square, which W's origin has at time 0.
  Eigen::Vector2d in_square(const Eigen::Vector2d& p_W, double time) const;
  /// Takes the window's middle to a place in cells, by whole cells.
  void follow(const Eigen::Vector2d& middle) { middle_ = middle.array().round(); }
  /// True if a place in cells has all its neighbours in the window.
  bool has(const Eigen::Vector2d& place) const;

  /// Factor of the waves by the damping of a time [s], along either axis.
  Eigen::VectorXf damping(int axis, double time) const;

  /// The heights on the square as the window has them at a time.
  SurfacePatch patch(const Eigen::MatrixXf& heights, double time) const;

  const Eigen::Vector2d& middle() const { return middle_; }
  void restore(const Eigen::Vector2d& middle) { middle_ = middle; }

 private:
  PeriodicSquare square_;
  Eigen::Vector2d current_;
  double edge_;
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();  ///< [cells]
};

}  // namespace hydro
