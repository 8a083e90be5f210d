#pragma once

#include <complex>
#include <vector>

#include "hydro/radiation/chebyshev_table.h"

/// @file
/// The waves of a pulsating source in water of finite depth.
///
/// With K = ω²/g, the wave number k of K = k tanh kh, r'' the distance of x and the mirror image of
/// y in the bottom z = −h, and the other symbols those of green_function.h,
///
///     G = 1/r + 1/r' + 1/r'' + K Re 𝒢(KR, −K(z_x + z_y)) + P(R, |z_x − z_y|)
///         + Q(R, z_x + z_y + 2h) + 2πi c C(z_x) C(z_y) J₀(kR),                               (1)
///     C(z) = cosh k(z + h)/cosh kh,     c = k²/(K + h (k² − K²)).
///
/// This is John's function [W60, eq. 13.18] with the product of its hyperbolic cosines written as a
/// sum, and the integral of deep water taken out of the part that is singular at the surface. With
/// E = e^{−2μh} and D = μ − K − (μ + K) E the rest is, in the sense of Cauchy,
///
///     P = ∫₀^∞ (μ + K) E (e^{μv} + e^{−μv})/D J₀(μR) dμ,                                     (2)
///     Q = ∫₀^∞ (μ + K) E [e^{−μv}/D + (μ + K) E e^{μv}/((μ − K) D)] J₀(μR) dμ.               (3)
///
/// The integrands fall at least as e^{−μ(2h − T)} for points down to the depth T < h, so P and Q
/// are smooth on the scales of h and 1/k. They are told by Chebyshev polynomials on pieces of R.
///
/// In the limit of high frequency, K = ∞, there are no waves, the surface has zero potential, and
/// G = 1/r − 1/r' + 1/r'' + P + Q.
///
/// [W60] Wehausen, Laitone. Surface waves. Encyclopedia of Physics IX (1960) 446-778.

namespace hydro {

/// A part of G that is smooth, and its slopes.
struct SmoothGreen {
  std::complex<double> value;
  std::complex<double> by_distance;  ///< By R.
  std::complex<double> by_height;    ///< By z_y.
};

class FiniteDepthGreen {
 public:
  /// @param deep_wave_number   K > 0; may be infinite [rad/m].
  /// @param depth              h [m]
  /// @param reach              Largest R [m].
  /// @param draught            Largest depth T of x and y, below h [m].
  FiniteDepthGreen(double deep_wave_number, double depth, double reach, double draught);

  /// All of (1) but 1/r, 1/r' and 1/r''. The slope by z_y is that without the 2K/r' of Re 𝒢.
  /// @param z_x, z_y   Heights above the still water level, −T to 0; not both are 0 where R is.
  SmoothGreen at(double distance, double z_x, double z_y) const;

 private:
  static constexpr int kOrder = 14;
  using Table = ChebyshevTable<kOrder>;

  /// P and Q for a range of R.
  struct Piece {
    Table bottom;  ///< P
    Table rest;    ///< Q
  };

  double deep_;                             ///< K
  double depth_;                            ///< h
  double wave_number_ = 0, amplitude_ = 0;  ///< k and 2πc; 0 without waves.
  double piece_;                            ///< Length of a piece of R.
  std::vector<Piece> pieces_;
};

}  // namespace hydro
