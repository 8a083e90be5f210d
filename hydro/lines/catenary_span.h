#pragma once

#include <Eigen/Core>

/// @file
/// The span of a line under given tensions, by (1) and (2) of catenary.h, and its derivatives by
/// the tensions.
///
/// Lengths are in units of L and forces in units of wL: (1) and (2) then know the compliance e =
/// wL/EA and the friction C_B alone, and the tensions h and v. Nothing cancels for light and taut
/// lines, nor for short parts.

namespace hydro {

/// A line in units of its own length and weight.
struct ScaledLine {
  double e = 0;         ///< wL/EA
  double friction = 0;  ///< C_B
  bool bottom = false;  ///< The part below the anchor rests on a flat bottom.
};

/// Integrals over a part that hangs, of the length `part`, from v_a to v = v_a + part:
/// ℓ = ∫ ds/T, sine = ∫ h²/T³ ds, cosine = ∫ h v/T³ ds, and ℓ sine − sine² − cosine².
struct HangingPart {
  double ell = 0, sine = 0, cosine = 0, gram = 0;
  double rise = 0;  ///< ∫ v/T ds
};

/// The integrals of a part under the horizontal tension h.
/// @param low   v_a
HangingPart hanging_part(double h, double low, double part);

/// x and z of (1) or (2), and their derivatives to h and v.
struct CatenarySpan {
  double x = 0, z = 0;
  double x_h = 0, x_v = 0, z_h = 0, z_v = 0, determinant = 0;

  /// Distance from (x, z).
  double error(const Eigen::Vector2d& wanted) const {
    return (Eigen::Vector2d(x, z) - wanted).norm();
  }
};

/// m of (2).
double pulled_length(const ScaledLine& line, double h, double resting);

/// The span under the tensions h > 0 and v at the fairlead; v > 0 of a line on a bottom.
CatenarySpan catenary_span(const ScaledLine& line, double h, double v);

}  // namespace hydro
