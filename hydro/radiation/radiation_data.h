#pragma once

#include <complex>
#include <limits>
#include <vector>

#include "hydro/spatial.h"

/// @file
/// The linear theory of a floating body: the waves that its motions radiate, and the load of waves
/// that it scatters.
///
/// The body moves little about its mean pose, without forward speed, in water of constant depth,
/// with no other body near. Its frame H has its origin in the centre of mass, z up, and horizontal
/// axes that turn with the body's heading: in the mean pose B is turned to H by
/// `MeanPose::orientation`, which has no heading (equilibrium.h). Everything below is in H, about
/// the centre of mass, for water of density 1.
///
/// Time goes as e^{−iωt}. A motion Re{u e^{−iωt}} meets the load
///
///     F = −A(ω) u' − B(ω) u,                                                                (1)
///
/// and a wave with the elevation Re{a e^{i(k·x − ωt)}} over the centre of mass exerts on the held
/// body, beyond hydrostatics,
///
///     F = Re{X(ω, β) a e^{i(k·x − ωt)}},        X = X_FK + X_D,                             (2)
///
/// of which X_FK is the pressure of the undisturbed wave (Froude and Krylov), and X_D the
/// diffraction: that of the waves which the held body scatters.

namespace hydro {

/// Six complex amplitudes.
using Vector6cd = Eigen::Matrix<std::complex<double>, 6, 1>;
/// A load of waves at one frequency, a column for each heading.
using Loads6cd = Eigen::Matrix<std::complex<double>, 6, Eigen::Dynamic>;

/// The pose about which a body's motion is small.
struct MeanPose {
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< R_HB, without heading.
  double height = 0;  ///< Height of the centre of mass above the still water level [m].

  /// Equal in every number.
  bool operator==(const MeanPose& other) const {
    return orientation.coeffs() == other.orientation.coeffs() && height == other.height;
  }
};

/// The water of a linear problem.
struct LinearWater {
  double gravity = 9.80665;                                ///< [m/s^2]
  double depth = std::numeric_limits<double>::infinity();  ///< [m]

  bool operator==(const LinearWater&) const = default;
};

/// Radiation, diffraction and Froude–Krylov loads of a body.
struct RadiationData {
  MeanPose pose;                     ///< Mean pose.
  LinearWater water;                 ///< Depth and gravity.
  double volume = 0;                 ///< Displaced in the mean pose [m^3]; 0 where it is not known.
  std::vector<double> frequencies;   ///< ω, ascending, > 0 [rad/s].
  std::vector<Matrix6d> added_mass;  ///< A(ω) for ρ = 1, symmetric; one a frequency.
  std::vector<Matrix6d> damping;     ///< B(ω) for ρ = 1, symmetric, ≥ 0; one a frequency.
  Matrix6d infinite_added_mass = Matrix6d::Zero();  ///< A in the limit of high frequency.
  /// Directions β in which waves travel, counter-clockwise from H's x axis, ascending in [0, 2π)
  /// [rad].
  std::vector<double> headings;
  std::vector<Loads6cd> froude_krylov;  ///< X_FK for ρ = 1; one a frequency.
  std::vector<Loads6cd> diffraction;    ///< X_D for ρ = 1; one a frequency.
};

}  // namespace hydro
