#pragma once

#include <Eigen/Geometry>

#include "hydro/radiation/radiation_data.h"
#include "hydro/spatial.h"

/// @file
/// Where the frame H of radiation_data.h lies while a body moves.
///
/// Linear theory knows a body near its mean pose, where H may turn with the whole body or with its
/// heading alone: the difference is of second order. Far from it H follows the wetted shape, which
/// turns with a ship that heels, and stays where it is under a ball that rolls. A turn about a
/// horizontal axis that moves no water tells the two apart. About an axis e through the point at c
/// from the centre of mass the velocity is (c × e, e), and
///
///     A∞ (c × e, e) = 0 (1)
///
/// holds for each such axis of a sphere and for the axis of a cylinder that lies on the water. H
/// then does not take part in the turn, and its origin is where the centre of mass would be without
/// it.

namespace hydro {

/// The pose of H.
struct WaveFrame {
  Eigen::Quaterniond R_WH = Eigen::Quaterniond::Identity();  ///< Rotation from H to W.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();          ///< From the centre of mass, in W [m].

  /// The velocity in H, about its origin, of a body's velocity in W, about its centre of mass.
  Vector6d velocity_in(const Vector6d& u_W) const;
  /// The load in W, about the centre of mass, of a load in H.
  Vector6d load_out(const Vector6d& load_H) const;
  /// The same for a symmetric tensor that gives loads from velocities.
  Matrix6d tensor_out(const Matrix6d& tensor_H) const;
  /// Angle of H's x axis from W's, counter-clockwise: the rotation about the vertical in R_WH
  /// [rad].
  double heading() const;
};

/// How the frame follows a body.
class WaveFrameRule {
 public:
  /// The turns that H does not take part in.
  enum class Slides {
    none,
    about_axis,  ///< About one horizontal axis: the wetted shape is a part of a solid of
                 ///< revolution.
    all          ///< The wetted shape is a part of a sphere.
  };

  /// Finds the rule of a body.
  /// @param vertices_B   The mesh's, from the centre of mass.
  /// @param added_H      A∞, symmetric.
  WaveFrameRule(const MeanPose& pose, const Eigen::Matrix3Xd& vertices_B, const Matrix6d& added_H);

  /// The turns of this body that H does not take part in.
  Slides slides() const { return slides_; }
  /// True if each turn of the body moves water: it is no solid of revolution about a horizontal
  /// axis or the vertical one.
  bool turns_water() const { return turns_water_; }
  /// The frame of a body with this orientation.
  WaveFrame at(const Eigen::Quaterniond& R_WB) const;

 private:
  Eigen::Quaterniond R_HB_;  ///< In the mean pose.
  Slides slides_ = Slides::none;
  bool turns_water_ = false;
  Eigen::Vector3d axis_H_ = Eigen::Vector3d::Zero();    ///< Unit; of Slides::about_axis.
  Eigen::Vector3d centre_H_ = Eigen::Vector3d::Zero();  ///< c [m].
};

}  // namespace hydro
