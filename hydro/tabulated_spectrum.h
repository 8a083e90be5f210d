#pragma once

#include <vector>

#include "hydro/airy_waves.h"

/// @file
/// An irregular sea from a spectrum that is given by numbers.

namespace hydro {

/// A wave spectrum S(ω) in a table: linear between its rows, zero outside.
struct TabulatedSpectrum {
  std::vector<double> frequencies;  ///< Ascending [rad/s], >= 0; at least two.
  std::vector<double> densities;    ///< S at the frequencies [m^2 s/rad], >= 0.
  /// Directions of travel at the frequencies, counter-clockwise from +x [rad]; none: all zero.
  std::vector<double> headings;
  double heading = 0;    ///< Added to all directions [rad].
  double spreading = 0;  ///< Exponent s of cos^2s(θ/2) about them; 0: long-crested waves.
  int seed = 1;          ///< Seed of the frequencies, phases and directions.
  int components = 64;   ///< Number of waves, >= 1.
};

/// Energy of the spectrum m_0, by which H_s = 4√m_0 [m^2].
double spectral_energy(const TabulatedSpectrum& spectrum);

/// Frequency of the row of the largest density [rad/s].
double peak_frequency(const TabulatedSpectrum& spectrum);

/// Returns waves of equal energy, whose sum is that of the table to round-off. The spectrum is cut
/// into bands of equal energy, and a wave at a random place of its energy represents each band: at
/// the bands' mean frequencies waves would repeat after 2π/Δω where the density is constant.
/// @param sea   Its depth, gravity and current. Frequencies are those in the frame of its water.
/// @throws std::invalid_argument if the energy is zero, or if frequencies are too high or too low
///     for waves
WaveSurface tabulated_sea(const TabulatedSpectrum& spectrum, const Sea& sea);

}  // namespace hydro
