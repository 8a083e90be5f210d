#pragma once

#include <cmath>

#include "hydro/spatial.h"

/// @file
/// Six-component quantities, and their components in frames that share an origin.

namespace engine {

using hydro::cross_matrix;
using hydro::Matrix6d;
using hydro::Vector6d;

inline Vector6d to_vector6(const Eigen::Vector3d& linear, const Eigen::Vector3d& angular) {
  Vector6d six;
  six << linear, angular;
  return six;
}
inline Vector6d to_vector6(const hydro::Wrench& w) { return to_vector6(w.force, w.moment); }
inline hydro::Wrench to_wrench(const Vector6d& six) { return {six.head<3>(), six.tail<3>()}; }

/// Components in A of a vector, or of a tensor, that is given in B.
inline Vector6d rotate(const Eigen::Matrix3d& R_AB, const Vector6d& six) {
  return to_vector6(R_AB * six.head<3>(), R_AB * six.tail<3>());
}
inline Matrix6d rotate_tensor(const Eigen::Matrix3d& R_AB, const Matrix6d& matrix) {
  Matrix6d result;
  for (const int i : {0, 3})
    for (const int j : {0, 3})
      result.block<3, 3>(i, j) = R_AB * matrix.block<3, 3>(i, j) * R_AB.transpose();
  return result;
}

/// True for a unit quaternion, as assertions ask, and for one that is not finite, which other
/// checks report.
inline bool is_unit(const Eigen::Quaterniond& q) { return !(std::abs(q.squaredNorm() - 1) > 1e-6); }

/// Norm of a velocity or acceleration whose angular part is multiplied by the radius [m].
inline double scaled_norm(const Vector6d& six, double radius) {
  return std::sqrt(six.head<3>().squaredNorm() + radius * radius * six.tail<3>().squaredNorm());
}

/// Velocity of a state, relative to water that moves with `current`, in W.
inline Vector6d velocity(const hydro::BodyState& state, const Eigen::Vector3d& current) {
  return to_vector6(state.linear_velocity - current, state.angular_velocity);
}

/// The state with this velocity relative to the water.
inline hydro::BodyState with_velocity(hydro::BodyState state, const Vector6d& relative,
                                      const Eigen::Vector3d& current) {
  state.linear_velocity = relative.head<3>() + current;
  state.angular_velocity = relative.tail<3>();
  return state;
}

}  // namespace engine
