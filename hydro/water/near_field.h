#pragma once

#include <Eigen/Core>

/// @file
/// The flow that the sources of one hull make about another one near by, where the grid's waves are
/// not all of it: that of 1/r − 1/r', with r' from the image in the surface. It falls as 1/r³.

namespace hydro {

/// Sources at places over the water, z from the still surface.
struct NearSources {
  Eigen::Matrix3Xd places;  ///< [m]
  Eigen::VectorXd rates;    ///< [m^3/s]
  Eigen::VectorXd changes;  ///< Rates of change of the rates [m^3/s^2].
};

struct NearFlow {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();      ///< ∇φ [m/s].
  double change = 0;                                       ///< ∂φ/∂t [m^2/s^2].
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< Its gradient [m/s^2].

  NearFlow& operator+=(const NearFlow& other);
};

/// The flow at a place that is none of the sources'.
NearFlow near_flow(const NearSources& sources, const Eigen::Vector3d& place);

}  // namespace hydro
