#pragma once

#include <complex>

/// @file
/// The waves of a pulsating source below the surface of deep water.
///
/// A source at y of strength Re{4π e^{−iωt}} has at x the potential G e^{−iωt},
///
///     G = 1/r + 1/r' + k 𝒢(X, Y),        X = k R,   Y = −k (z_x + z_y),   k = ω²/g,          (1)
///
/// with r the distance of x and y, r' that of x and the mirror image of y in the surface, and R
/// their horizontal distance. With ρ = √(X² + Y²) = k r',
///
///     𝒢 = F + 2πi e^{−Y} J₀(X),
///     F = −2π e^{−Y} Y₀(X) − 2 ∫₀^∞ e^{−v} / √(X² + (Y − v)²) dv,                            (2)
///     ∂𝒢/∂Y = −𝒢 − 2/ρ.                                                                      (3)
///
/// (2) is Newman's form [N85] with the Struve function joined to the integral. The integral is told
/// by Chebyshev polynomials: near the source by those of F + 2 J₀ e^{−Y} ln((ρ + Y)/2), which is
/// analytic in ρ and Y/ρ; far away by those of the integral itself, in 1/ρ and Y/ρ; and deep below
/// the surface by its asymptotic series. Their coefficients are found at the first call, in a few
/// milliseconds. The error is below 1e-7 of 1 + |𝒢| (green_function_test.cpp).
///
/// [N85] Newman. Algorithms for the free-surface Green function. J. Eng. Math. 19 (1985) 57-67.

namespace hydro {

/// 𝒢 and its slope by X.
struct WaveGreen {
  std::complex<double> value;
  std::complex<double> by_x;  ///< ∂𝒢/∂X
};

/// @param x   X >= 0.  @param y   Y >= 0; not both are 0.
WaveGreen wave_green(double x, double y);

/// ∫₀^∞ e^{−v} / √(x² + (y − v)²) dv by quadrature to some 1e-12, for x > 0: slow.
double wave_green_integral(double x, double y);

}  // namespace hydro
