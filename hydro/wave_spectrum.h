#pragma once

#include "hydro/airy_waves.h"

/// @file
/// An irregular sea as a sum of linear waves.

namespace hydro {

/// JONSWAP spectrum over angular frequency ω in deep water [H73]: with ω_p = 2π/T_p,
///
///     S(ω) ∝ ω^-5 exp(−5/4 (ω_p/ω)^4) γ^exp(−(ω/ω_p − 1)² / (2σ²)),  σ = 0.07 below ω_p, 0.09
///     above,
///
/// scaled so that 4√m_0 is exactly the significant height for any γ. Directions spread as
/// cos^2s(θ/2) about the heading, equally at all frequencies [L63].
///
/// [H73] Hasselmann et al. Measurements of wind-wave growth and swell decay. Dtsch. Hydrogr. Z. A8
///       (12), 1973.
/// [L63] Longuet-Higgins, Cartwright, Smith. Observations of the directional spectrum of sea waves
///       using the motions of a floating buoy. Ocean Wave Spectra, 1963.
struct JonswapSpectrum {
  double significant_height = 1;  ///< H_s [m].
  double peak_period = 7;         ///< T_p [s].
  double gamma = 3.3;             ///< Peak enhancement [-]; 1 gives Pierson–Moskowitz.
  double heading = 0;             ///< Main direction of travel, counter-clockwise from +x [rad].
  double spreading = 0;  ///< Exponent s; 0 stands for long-crested waves (all at `heading`).
  int seed = 1;          ///< Seed of the phases and directions.
  int components = 64;   ///< Number of waves, >= 1.
};

/// Returns waves of equal energy: the spectrum is cut into bands of equal energy, and a wave at the
/// mean frequency represents each band, so m_0 and m_1 equal those of the spectrum and the sea has
/// no repeat period. Phases are random and uniform. Frequencies above 20 ω_p (1e-5 of the energy)
/// are left out.
/// @param sea   Its depth, gravity and current. Frequencies are those in the frame of its water, so
///   that an adverse current stops no wave.
WaveSurface jonswap_sea(const JonswapSpectrum& spectrum, const Sea& sea);

/// S(ω) without its scale [-].
double jonswap_shape(double omega, double peak_omega, double gamma);

}  // namespace hydro
