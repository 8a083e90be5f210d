#include "hydro/wave_spectrum.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "hydro/wave_directions.h"

namespace hydro {
namespace {

/// Steps of the frequency integrals, for which the error of the midpoint rule is below 1e-6.
constexpr int kFrequencySteps = 40000;
constexpr double kHighestFrequency = 20;  ///< In units of ω_p.

/// Wave number in the frame of the water [rad/m].
double wave_number_in_water(double omega, double depth, double gravity) {
  const auto k = wave_number(omega, depth, gravity);
  if (!k) throw std::invalid_argument("its periods are too long or too short for waves");
  return *k;
}

/// Energy of the spectrum in each of the frequency steps [-].
std::vector<double> step_energies(const JonswapSpectrum& spectrum, const Sea& sea, double width) {
  std::vector<double> energy(kFrequencySteps);
  for (int i = 0; i < kFrequencySteps; ++i) {
    const double ratio = (i + 0.5) * width;
    energy[i] = jonswap_shape(ratio, 1, spectrum.gamma);
    if (spectrum.tma)
      energy[i] *= depth_factor(ratio * 2 * M_PI / spectrum.peak_period, sea.depth, sea.gravity);
  }
  return energy;
}

/// Mean frequencies of bands of equal energy, in units of ω_p.
std::vector<double> band_frequencies(const JonswapSpectrum& spectrum, const Sea& sea) {
  const int count = spectrum.components;
  const double width = kHighestFrequency / kFrequencySteps;
  const std::vector<double> energy = step_energies(spectrum, sea, width);
  const double total = std::accumulate(energy.begin(), energy.end(), 0.0);
  if (!(total > 0)) throw std::invalid_argument("its waves are too long for the depth");
  std::vector<double> means;
  double in_band = 0;  // energy and first moment of the current band
  double moment = 0;
  const double band = total / count;
  for (int i = 0; i < kFrequencySteps; ++i) {
    double left = energy[i];
    const double omega = (i + 0.5) * width;
    while (in_band + left >= band && static_cast<int>(means.size()) < count - 1) {
      const double part = band - in_band;
      means.push_back((moment + part * omega) / band);
      left -= part;
      in_band = moment = 0;
    }
    in_band += left;
    moment += left * omega;
  }
  means.push_back(moment / in_band);
  return means;
}

}  // namespace

double jonswap_shape(double omega, double peak_omega, double gamma) {
  const double ratio = omega / peak_omega;
  const double sigma = ratio <= 1 ? 0.07 : 0.09;
  const double peak = std::exp(-(ratio - 1) * (ratio - 1) / (2 * sigma * sigma));
  return std::pow(ratio, -5) * std::exp(-1.25 * std::pow(ratio, -4)) * std::pow(gamma, peak);
}

double depth_factor(double omega, double depth, double gravity) {
  const double kh = wave_number_in_water(omega, depth, gravity) * depth;
  if (!(kh < 20)) return 1;  // 1 − φ is below round-off
  const double t = std::tanh(kh);
  return t * t / (1 + 2 * kh / std::sinh(2 * kh));
}

double usual_gamma(double significant_height, double peak_period) {
  const double ratio = peak_period / std::sqrt(significant_height);
  if (ratio <= 3.6) return 5;
  return ratio >= 5 ? 1 : std::exp(5.75 - 1.15 * ratio);
}

WaveSurface jonswap_sea(const JonswapSpectrum& spectrum, const Sea& sea) {
  UniformNumbers uniform(spectrum.seed);
  const double variance = spectrum.significant_height * spectrum.significant_height / 16;
  const double amplitude = std::sqrt(2 * variance / spectrum.components);
  const double peak_omega = 2 * M_PI / spectrum.peak_period;
  const std::vector<double> angles =
      spread_directions(spectrum.spreading, spectrum.components, uniform);
  WaveSurface waves;
  const std::vector<double> frequencies = band_frequencies(spectrum, sea);
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    const double k = wave_number_in_water(frequencies[i] * peak_omega, sea.depth, sea.gravity);
    waves.components.push_back(
        linear_wave(sea, amplitude, k, spectrum.heading + angles[i], 2 * M_PI * uniform()));
  }
  return waves;
}

}  // namespace hydro
