#pragma once

#include <Eigen/Core>

/// @file
/// The camera's mathematics.
///
/// Frame E has the axes of W and its origin in the camera's eye: graphics devices work in single
/// precision, and near the eye that is precise wherever in the world the scene lies.

namespace render {

struct Camera {
  Eigen::Vector3d from = {6, -8, 3};  ///< Eye, in W [m].
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  double field_of_view = 0.6108652381980153;  ///< Vertical [rad].
  Eigen::Vector3d up =
      Eigen::Vector3d::UnitZ();  ///< Direction toward the top of the picture, in W.

  bool operator==(const Camera&) const = default;
};

struct View {
  Eigen::Vector3d eye_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d forward_W = Eigen::Vector3d::UnitY();  ///< Unit.
  Eigen::Vector3d right_W = Eigen::Vector3d::UnitX();    ///< Unit.
  Eigen::Vector3d up_W = Eigen::Vector3d::UnitZ();       ///< Unit.
  Eigen::Vector3d level_W = Eigen::Vector3d::UnitX();    ///< `right_W` of a camera with +z up.
  double distance = 1;     ///< Distance from the eye to the point looked at [m].
  double half_width = 1;   ///< Tangent of half the horizontal field of view [-].
  double half_height = 1;  ///< Tangent of half the vertical field of view [-].
  double near = 0;         ///< Nothing nearer is drawn [m].
  double far = 0;          ///< Nothing farther is drawn [m].
  Eigen::Matrix4d clip_from_E = Eigen::Matrix4d::Identity();

  /// Direction of the ray through a point of the picture, x and y from -1 to 1, y up; its component
  /// along `forward_W` is 1.
  Eigen::Vector3d ray(double x, double y) const {
    return forward_W + x * half_width * right_W + y * half_height * up_W;
  }
};

/// Returns the visible height at the distance of the point looked at [m].
inline double picture_size(const View& view) { return 2 * view.half_height * view.distance; }

/// Returns the spacing of the grid lines on water and ground, a round number [m].
double grid_length(const View& view);

/// Returns the direction toward the main light, unit, over the camera's left shoulder, so that
/// every view shows shape. In W; its z is positive.
Eigen::Vector3d key_light(const View& view);

/// Makes the view of a camera. A camera that looks along its `up` has +y at the top of its picture.
View make_view(const Camera& camera, int width, int height);

}  // namespace render
