#pragma once

#include <Eigen/Core>

#include "app/render/renderer.h"

/// @file
/// A camera that a hand moves, and where in the world a point of the window lies.
///
/// A point of the window is given from its middle, x right and y up, in half heights: the top edge
/// is at y = 1.

namespace app {

/// A camera by the place of its eye about the point that it looks at.
struct Orbit {
  Eigen::Vector3d to = Eigen::Vector3d::Zero();  ///< In W [m].
  double distance = 1;                           ///< [m]
  double azimuth = 0;        ///< Of the eye seen from there, 0 on +x, from above to the left [rad].
  double elevation = 0;      ///< Of the eye seen from there, up [rad].
  double field_of_view = 1;  ///< Vertical [rad].
};

Orbit orbit_of(const render::Camera& camera);
render::Camera camera_of(const Orbit& orbit);

/// The scene turned under a hand that goes by `way`, half a turn over the window's height. The eye
/// stays clear of the vertical through the point looked at.
Orbit turned(Orbit orbit, const Eigen::Vector2d& way);

/// The scene moved with a hand: what lies as far as the point looked at goes by `way`.
Orbit panned(Orbit orbit, const Eigen::Vector2d& way);

/// Nearer by 15 % a notch of the wheel, or farther; between a millimetre and 1000 km.
Orbit zoomed(Orbit orbit, double notches);

/// All that a point of the window shows.
struct Ray {
  Eigen::Vector3d from_W = Eigen::Vector3d::Zero();   ///< The eye [m].
  Eigen::Vector3d along_W = Eigen::Vector3d::Zero();  ///< Its part along the camera's view is 1.
};

Ray ray_through(const render::Camera& camera, const Eigen::Vector2d& point);

}  // namespace app
