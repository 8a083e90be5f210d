#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

/// @file
/// Six-component quantities and the state of a rigid body.
///
/// Frames   W  world: z up, right-handed.   B  body: origin at the centre of mass.
/// Order    of six is always surge, sway, heave, roll, pitch, yaw: translation first.
/// Units    SI.

namespace hydro {

/// Six components: translation first.
using Vector6d = Eigen::Matrix<double, 6, 1>;
/// A matrix over six components.
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// The matrix [v]× with [v]× w = v × w for any w.
inline Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// Preconditions that functions assert. A quantity that is not a number passes: it is the caller's
// to report.

/// True unless a quaternion departs from a rotation by more than roundings make of it.
inline bool is_unit(const Eigen::Quaterniond& q) { return !(std::abs(q.squaredNorm() - 1) > 1e-6); }
/// True unless a vector departs from unit length by more than roundings make of it.
inline bool is_unit(const Eigen::Vector3d& v) { return !(std::abs(v.squaredNorm() - 1) > 1e-6); }

/// True unless a matrix departs from a symmetric one by more than roundings make of it.
template <class Matrix>
bool is_symmetric(const Matrix& m) {
  return !((m - m.transpose()).cwiseAbs().maxCoeff() > 1e-9 * m.cwiseAbs().maxCoeff());
}

/// A force [N] and a moment [N m]. The point of the moment is the body's centre of mass unless the
/// function that returns the wrench says otherwise.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< [N m]

  /// Adds a wrench about the same point.
  Wrench& operator+=(const Wrench& other) {
    force += other.force;
    moment += other.moment;
    return *this;
  }
};

/// The sum of two wrenches about the same point.
inline Wrench operator+(Wrench a, const Wrench& b) { return a += b; }
/// A wrench times a factor.
inline Wrench operator*(double factor, const Wrench& w) {
  return {factor * w.force, factor * w.moment};
}

/// Motion of a rigid body relative to the water: the velocity of its centre of mass [m/s] and its
/// angular velocity [rad/s], in W.
struct Twist {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< [m/s]
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< [rad/s]

  /// Velocity of the body's point at `r` from the centre of mass, W axes [m/s].
  Eigen::Vector3d at(const Eigen::Vector3d& r) const { return linear + angular.cross(r); }
};

/// The changing part of a rigid body. A value: it can be copied, compared and replayed.
struct BodyState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< p_WB, of the centre of mass [m].
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< R_WB, unit.
  /// Velocity of the centre of mass, in W [m/s].
  Eigen::Vector3d linear_velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< In W [rad/s].

  /// Equal in every number.
  bool operator==(const BodyState& other) const {
    return position == other.position && orientation.coeffs() == other.orientation.coeffs() &&
           linear_velocity == other.linear_velocity && angular_velocity == other.angular_velocity;
  }
};

}  // namespace hydro
