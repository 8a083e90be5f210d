#pragma once

#include <complex>
#include <vector>

/// @file
/// Spectra of evenly spaced signals by Welch's method: the mean of the periodograms of segments
/// that overlap by half, under Hann's window, each without its trend.
/// [Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70-73.]

namespace app {

/// A one-sided density: its integral over the frequency is the variance.
struct PowerSpectrum {
  std::vector<double> frequencies;  ///< [Hz], from 0.
  std::vector<double> density;      ///< [unit^2 / Hz]
  int segments = 0;

  /// Returns the n-th moment, ∫ f^n S df, without the frequency 0.
  double moment(int n) const;
  /// Returns the frequency of the largest density [Hz].
  double peak() const;
};

/// The linear response of one signal to another.
struct TransferFunction {
  std::vector<double> frequencies;             ///< [Hz]
  std::vector<std::complex<double>> response;  ///< Its argument is the phase by which it leads.
  std::vector<double>
      coherence;              ///< 0 to 1: the share of the response that is linear in the input.
  std::vector<double> input;  ///< Density of the input [unit^2 / Hz].
  int segments = 0;
};

/// @param rate      Samples a second [Hz].
/// @param segment   Samples in a segment, 8 to the number of samples.
PowerSpectrum power_spectrum(const std::vector<double>& values, double rate, std::size_t segment);

/// Returns the cross spectrum of two signals over the spectrum of the input.
TransferFunction transfer_function(const std::vector<double>& input,
                                   const std::vector<double>& output, double rate,
                                   std::size_t segment);

/// Returns the length of a segment for eight of them, which overlap by half.
std::size_t usual_segment(std::size_t samples);

}  // namespace app
