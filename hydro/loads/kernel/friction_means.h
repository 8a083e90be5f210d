#pragma once

#include <array>

/// @file
/// Means of the ITTC line over the speeds below one, with which friction about a pole becomes a sum
/// over edges.

namespace hydro::kernel {

/// Reynolds number below which the ITTC line is held, and its C_v there (`viscous_drag.cpp`).
inline constexpr double kLeastReynolds = 1e4;
inline constexpr double kHeldCoefficient = 0.075 / 4;

/// Coefficients of the polynomials in FrictionMeans. With this many the error is below 1e-8.
inline constexpr int kMeanTerms = 17;

/// The weighted means
///
///     C_n(Re) = n/Reⁿ ∫_0^Re C_v(R) R^{n−1} dR,      n = 3, 5,                              (1)
///
/// of the line C_v = K z², z = 1/ln(Re/100), for Re from kLeastReynolds to kMostReynolds:
///
///     C_n = K z² Σ_i c_i sⁱ,      s = (z − middle)/half from −1 to 1.                       (2)
struct FrictionMeans {
  double K = 0, middle = 0, half = 0;
  std::array<double, kMeanTerms> third = {}, fifth = {};  ///< c_i for n = 3 and 5.
};

inline constexpr double kMostReynolds = 1e14;

/// Places from the middle on and weights of Gauss' rule of five points on −1 to 1.
inline constexpr double kGaussAt[] = {0, 0.5384693101056831, 0.9061798459386640};
inline constexpr double kGaussWeight[] = {0.5688888888888889, 0.4786286704993665,
                                          0.2369268850561891};

const FrictionMeans& friction_means();

}  // namespace hydro::kernel
