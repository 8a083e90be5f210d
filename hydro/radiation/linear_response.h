#pragma once

#include <array>

#include "hydro/radiation/radiation_data.h"
#include "hydro/radiation/radiation_memory.h"

/// @file
/// The steady motion of a floating body in a regular wave, by linear theory.
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

/// The matrix that takes six components from a frame to one in which the former's x axis has this
/// heading, counter-clockwise about the vertical [rad].
Matrix6d turn_of_heading(double heading);

}  // namespace hydro
