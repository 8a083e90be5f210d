#pragma once

#include "hydro/airy_waves.h"

/// @file
/// An irregular sea as a sum of linear waves.

namespace hydro {

/// JONSWAP spectrum over angular frequency ω [H73]: with ω_p = 2π/T_p,
///
///     S(ω) ∝ ω^-5 exp(−5/4 (ω_p/ω)^4) γ^exp(−(ω/ω_p − 1)² / (2σ²)),  σ = 0.07 below ω_p, 0.09
///     above,
///
/// scaled so that 4√m_0 is exactly the significant height for any γ. With γ = 1 it is the spectrum
/// of Pierson and Moskowitz, and of Bretschneider, for a height and a period. Directions spread as
/// cos^2s(θ/2) about the heading, equally at all frequencies [L63].
///
/// The TMA spectrum of wind waves on water of depth h is the same times the factor of
/// Kitaigorodskii [B85], which leaves the density over wave numbers in the tail that of deep water:
///
///     φ(ω) = (k^-3 ∂k/∂ω) / (k^-3 ∂k/∂ω)_deep = tanh² kh / (1 + 2kh / sinh 2kh).
///
/// [H73] Hasselmann et al. Measurements of wind-wave growth and swell decay. Dtsch. Hydrogr. Z. A8
///       (12), 1973.
/// [L63] Longuet-Higgins, Cartwright, Smith. Observations of the directional spectrum of sea waves
///       using the motions of a floating buoy. Ocean Wave Spectra, 1963.
/// [B85] Bouws, Günther, Rosenthal, Vincent. Similarity of the wind wave spectrum in finite depth
///       water 1. J. Geophys. Res. 90 (C1) 975-986, 1985.
struct JonswapSpectrum {
  double significant_height = 1;  ///< H_s [m].
  double peak_period = 7;         ///< T_p [s].
  double gamma = 3.3;             ///< Peak enhancement γ [-].
  bool tma = false;               ///< True: times φ of the sea's depth.
  double heading = 0;             ///< Main direction of travel, counter-clockwise from +x [rad].
  double spreading = 0;  ///< Exponent s; 0 stands for long-crested waves (all at `heading`).
  int seed = 1;          ///< Seed of the phases and directions.
  int components = 64;   ///< Number of waves, >= 1.
};

/// Returns waves of equal energy: the spectrum is cut into bands of equal energy, and a wave at the
/// mean frequency represents each band, so m_0 and m_1 equal those of the spectrum and the sea has
/// no repeat period. Phases are random and uniform. Frequencies above 20 ω_p (1e-5 of the energy,
/// of TMA in very shallow water 0.3 %) are left out.
/// @param sea   Its depth, gravity and current. Frequencies are those in the frame of its water, so
///   that an adverse current stops no wave.
/// @throws std::invalid_argument if the numbers are too large or too small for waves
WaveSurface jonswap_sea(const JonswapSpectrum& spectrum, const Sea& sea);

/// S(ω) without its scale and without φ [-].
double jonswap_shape(double omega, double peak_omega, double gamma);

/// φ(ω) of the TMA spectrum [-]: 1 in deep water.
/// @param omega   Frequency in the frame of the water [rad/s], > 0.
/// @throws std::invalid_argument if no wave has this frequency, for example without gravity
double depth_factor(double omega, double depth, double gravity);

/// Peak enhancement γ of a sea of which no more is known than its height and period [D19]: 5 for
/// T_p/√H_s up to 3.6, 1 from 5 on, exp(5.75 − 1.15 T_p/√H_s) between.
///
/// [D19] DNV-RP-C205, Environmental conditions and environmental loads, 3.5.5.
double usual_gamma(double significant_height, double peak_period);

}  // namespace hydro
