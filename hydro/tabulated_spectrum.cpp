#include "hydro/tabulated_spectrum.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hydro/wave_directions.h"

namespace hydro {
namespace {

/// Energy below each of the frequencies [m^2], exact for the linear density.
std::vector<double> energies_below(const TabulatedSpectrum& spectrum) {
  std::vector<double> sums(spectrum.frequencies.size(), 0.0);
  for (std::size_t i = 1; i < sums.size(); ++i)
    sums[i] = sums[i - 1] + (spectrum.frequencies[i] - spectrum.frequencies[i - 1]) *
                                (spectrum.densities[i - 1] + spectrum.densities[i]) / 2;
  return sums;
}

/// A place between two rows of the table.
struct Place {
  std::size_t row;  ///< The upper row.
  double part;      ///< 0 at the lower row, 1 at the upper one.
};

/// The place below which this energy lies.
Place place_of_energy(const TabulatedSpectrum& spectrum, const std::vector<double>& below,
                      double energy) {
  const auto above = std::upper_bound(below.begin(), below.end(), energy);
  const auto last = static_cast<std::ptrdiff_t>(below.size()) - 1;
  const auto row =
      static_cast<std::size_t>(std::clamp(above - below.begin(), std::ptrdiff_t{1}, last));
  const double low = spectrum.densities[row - 1], high = spectrum.densities[row];
  const double width = spectrum.frequencies[row] - spectrum.frequencies[row - 1];
  // The root of low t + (high − low) t²/2 = e, without a difference of near numbers.
  const double e = (energy - below[row - 1]) / width;
  const double root = std::sqrt(std::max(0.0, low * low + 2 * (high - low) * e));
  return {row, std::min(1.0, 2 * e / (low + root))};
}

double linear_at(const std::vector<double>& values, const Place& place) {
  return (1 - place.part) * values[place.row - 1] + place.part * values[place.row];
}

/// Direction at a place, on the shorter way between two rows [rad].
double heading_at(const std::vector<double>& headings, const Place& place) {
  if (headings.empty()) return 0;
  const double turn = std::remainder(headings[place.row] - headings[place.row - 1], 2 * M_PI);
  return headings[place.row - 1] + place.part * turn;
}

}  // namespace

double spectral_energy(const TabulatedSpectrum& spectrum) {
  return energies_below(spectrum).back();
}

double peak_frequency(const TabulatedSpectrum& spectrum) {
  const auto peak = std::max_element(spectrum.densities.begin(), spectrum.densities.end());
  return spectrum.frequencies[static_cast<std::size_t>(peak - spectrum.densities.begin())];
}

WaveSurface tabulated_sea(const TabulatedSpectrum& spectrum, const Sea& sea) {
  const std::vector<double> below = energies_below(spectrum);
  if (!(below.back() > 0)) throw std::invalid_argument("its energy is zero");
  UniformNumbers uniform(spectrum.seed);
  const double band = below.back() / spectrum.components;
  const std::vector<double> angles =
      spread_directions(spectrum.spreading, spectrum.components, uniform);
  WaveSurface waves;
  for (int i = 0; i < spectrum.components; ++i) {
    const Place place = place_of_energy(spectrum, below, (i + uniform()) * band);
    const auto k = wave_number(linear_at(spectrum.frequencies, place), sea.depth, sea.gravity);
    if (!k) throw std::invalid_argument("its frequencies are too high or too low for waves");
    const double heading = spectrum.heading + heading_at(spectrum.headings, place) +
                           angles[static_cast<std::size_t>(i)];
    waves.components.push_back(
        linear_wave(sea, std::sqrt(2 * band), *k, heading, 2 * M_PI * uniform()));
  }
  return waves;
}

}  // namespace hydro
