#pragma once

#include <Eigen/Core>

#include "app/render/renderer.h"

/// @file
/// Camera moved by the mouse, and rays through points of the window.
///
/// A point of the window is given from its middle, x right and y up, in half heights: the top edge
/// is at y = 1.

namespace app {

/// Camera given by the spherical coordinates of its eye about the point that it looks at.
struct Orbit {
  Eigen::Vector3d to = Eigen::Vector3d::Zero();  ///< Point looked at, in W [m].
  double distance = 1;                           ///< [m]
  double azimuth = 0;        ///< Azimuth of the eye seen from `to`, 0 on +x, positive to +y [rad].
  double elevation = 0;      ///< Elevation of the eye seen from `to` [rad].
  double field_of_view = 1;  ///< Vertical [rad].
};

Orbit orbit_of(const render::Camera& camera);
render::Camera camera_of(const Orbit& orbit);

/// Returns the orbit after a drag by `way` that turns the scene, by half a turn for the window's
/// height. The elevation stays below that of the vertical.
Orbit turned(Orbit orbit, const Eigen::Vector2d& way);

/// Returns the orbit after a drag by `way` that moves the scene: points as far away as `to` follow
/// the mouse.
Orbit panned(Orbit orbit, const Eigen::Vector2d& way);

/// Returns the orbit with the distance reduced by 15 % per notch of the wheel, within 1 mm and 1000
/// km.
Orbit zoomed(Orbit orbit, double notches);

/// Line of sight through a point of the window.
struct Ray {
  Eigen::Vector3d from_W = Eigen::Vector3d::Zero();   ///< The eye [m].
  Eigen::Vector3d along_W = Eigen::Vector3d::Zero();  ///< Unit component along the view.
};

Ray ray_through(const render::Camera& camera, const Eigen::Vector2d& point);

}  // namespace app
