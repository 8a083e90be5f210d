#pragma once

#include <array>
#include <functional>
#include <vector>

#include "hydro/radiation/radiation_data.h"
#include "hydro/radiation/radiation_memory.h"

/// @file
/// The steady motion of a floating body in a regular wave, and its natural modes, by linear theory.
///
/// Under the load Re{F e^{−iωt}} a body that moves little about a mean pose at rest follows with
/// Re{ξ e^{−iωt}}, translations [m] and small rotations [rad] of its centre of mass:
///
///     [−ω² (M + A∞) − iω (D + H̄(iω)) + C] ξ = F,                                            (1)
///
/// with the memory H of radiation_memory.h, whose response stands for s = iω and is conjugate at
/// s = −iω; of A and B,
///
///     A(ω) = A∞ + Im H/ω,        B(ω) = Re H.                                                (2)
///
/// Without damping and load it can oscillate freely in natural modes, with the added mass of the
/// very frequency at which they do,
///
///     C ξ = ω² (M + A(ω)) ξ.                                                                 (3)
///
/// Everything is about the centre of mass, in one frame of any heading.

namespace hydro {

/// The terms of (1) that do not depend on the frequency.
struct LinearBody {
  Matrix6d inertia = Matrix6d::Zero();    ///< M + A∞ [kg, kg m, kg m^2].
  Matrix6d damping = Matrix6d::Zero();    ///< D, of other than waves [N s/m, N s, N m s].
  Matrix6d stiffness = Matrix6d::Zero();  ///< C [N/m, N, N m].
  std::array<bool, 6> locked = {};        ///< Motions that are zero.
};

/// ξ of (1).
/// @param memory      H(iω), with the density of the water.
/// @param frequency   ω, > 0 [rad/s].
/// @param load        F, in the frame of the body's matrices [N, N m].
Vector6cd linear_response(const LinearBody& body, const Matrix6cd& memory, double frequency,
                          const Vector6cd& load);

/// A free oscillation (3).
struct NaturalMode {
  double frequency = 0;               ///< ω, > 0 [rad/s].
  Vector6d shape = Vector6d::Zero();  ///< ξ of unit potential energy ½ ξᵀ C ξ [m, rad].
};

/// The natural modes by ascending frequency: as many as C has positive eigenvalues among the
/// motions that are not locked. A mode without restoring, as surge without moorings, or with a
/// negative one, as the roll of a body that capsizes, has none. The k-th eigenvalue of (3) for a
/// given A, by size, depends continuously on ω, and where it equals ω² is a mode.
/// @param body     Its inertia is M + A∞; its damping does not matter, and of its stiffness the
///                 symmetric part counts.
/// @param excess   A(ω) − A∞, which leaves M + A(ω) positive; null: zero. It is asked for ω > 0.
std::vector<NaturalMode> natural_modes(const LinearBody& body,
                                       const std::function<Matrix6d(double)>& excess = nullptr);

/// Im H/ω of (2) [kg, kg m, kg m^2].
Matrix6d memory_mass(const Matrix6cd& memory, double frequency);

/// The matrix that takes six components from a frame to one in which the former's x axis has this
/// heading, counter-clockwise about the vertical [rad].
Matrix6d turn_of_heading(double heading);

}  // namespace hydro
