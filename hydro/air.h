#pragma once

#include <Eigen/Core>
#include <cmath>

/// @file
/// The air above the water.

namespace hydro {

/// A steady horizontal wind. At the height z above the water it has the velocity
///
///     U(z) = velocity · (z / height)^exponent,                                             (1)
///
/// the power law of a boundary layer; 0.11 is the usual exponent over the open sea (IEC 61400-3,
/// DNV-RP-C205), 0.14 that over smooth land. With the exponent 0 the wind is uniform.
struct Wind {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< Where the air goes, in W [m/s]; z is 0.
  double height = 10;   ///< Height above the water where `velocity` holds [m], > 0.
  double exponent = 0;  ///< [-], 0 … 1.

  /// True if the velocity is the same at all heights.
  bool uniform() const { return exponent == 0 || velocity.isZero(0); }

  /// Speed at a height z >= 0 above the water over that at `height` [-].
  double factor(double z) const { return uniform() ? 1 : std::pow(z / height, exponent); }
};

/// The air above the water.
struct Air {
  double density = 1.225;  ///< [kg/m^3], > 0; that of the standard atmosphere at sea level.
  Wind wind;               ///< Motion of the air.
};

}  // namespace hydro
