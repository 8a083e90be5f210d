#include "hydro/measured_elevation.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <stdexcept>
#include <unsupported/Eigen/FFT>

namespace hydro {
namespace {

/// A wave of the Fourier series of a record: amplitude cos(omega t + phase), t from its start.
struct Harmonic {
  double amplitude;  ///< [m]
  double omega;      ///< [rad/s]
  double phase;      ///< [rad]

  double energy() const { return amplitude * amplitude / 2; }
};

/// Returns the waves below half the sampling frequency; that at half of it has no phase of its own.
std::vector<Harmonic> harmonics_of(const ElevationRecord& record) {
  std::vector<std::complex<double>> lines;
  Eigen::FFT<double>().fwd(lines, record.elevations);
  const std::size_t count = record.elevations.size();
  std::vector<Harmonic> harmonics;
  for (std::size_t j = 1; 2 * j < count; ++j)
    harmonics.push_back({.amplitude = 2 * std::abs(lines[j]) / static_cast<double>(count),
                         .omega = 2 * M_PI * static_cast<double>(j) / record.length(),
                         .phase = std::arg(lines[j])});
  return harmonics;
}

/// Energy of the wave at half the sampling frequency, which an odd number of elevations lacks
/// [m^2].
double nyquist_energy(const std::vector<double>& elevations) {
  if (elevations.size() % 2 == 1) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < elevations.size(); i += 2) sum += elevations[i] - elevations[i + 1];
  const double amplitude = sum / static_cast<double>(elevations.size());
  return amplitude * amplitude;
}

/// Frequency of the largest mean energy, each mean over a tenth of its frequency [rad/s].
double smoothed_peak(const std::vector<Harmonic>& harmonics) {
  std::vector<double> sums = {0};
  for (const Harmonic& h : harmonics) sums.push_back(sums.back() + h.energy());
  double largest = -1, peak = 0;
  for (std::size_t i = 0; i < harmonics.size(); ++i) {
    const std::size_t half = std::min({(i + 1) / 20, i, harmonics.size() - 1 - i});
    const double mean = (sums[i + half + 1] - sums[i - half]) / static_cast<double>(2 * half + 1);
    if (mean <= largest) continue;
    largest = mean;
    peak = harmonics[i].omega;
  }
  return peak;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The step from the last elevation to the first over the largest of the others.
double jump_of(const std::vector<double>& elevations) {
  double largest = 0;
  for (std::size_t i = 1; i < elevations.size(); ++i)
    largest = std::max(largest, std::abs(elevations[i] - elevations[i - 1]));
  return std::abs(elevations.front() - elevations.back()) / largest;
}

/// Splits harmonics into those of a band, which are returned, and the energy of the others.
std::vector<Harmonic> in_band(const std::vector<Harmonic>& harmonics, ElevationFit& fit) {
  // Ends that are harmonics themselves belong to the band.
  constexpr double kRoundOff = 1e-9;
  std::vector<Harmonic> inside;
  for (const Harmonic& h : harmonics) {
    if (h.omega < (1 - kRoundOff) * fit.lowest)
      fit.below += h.energy();
    else if (h.omega > (1 + kRoundOff) * fit.highest)
      fit.above += h.energy();
    else
      inside.push_back(h);
  }
  return inside;
}

/// Keeps the waves of the largest energy, in the order of their frequencies.
void keep_largest(std::size_t count, std::vector<Harmonic>& harmonics, ElevationFit& fit) {
  if (harmonics.size() <= count) return;
  std::stable_sort(harmonics.begin(), harmonics.end(),
                   [](const Harmonic& a, const Harmonic& b) { return a.energy() > b.energy(); });
  for (std::size_t i = count; i < harmonics.size(); ++i) fit.dropped += harmonics[i].energy();
  harmonics.resize(count);
  std::sort(harmonics.begin(), harmonics.end(),
            [](const Harmonic& a, const Harmonic& b) { return a.omega < b.omega; });
}

/// Returns waves that are the harmonics at the gauge.
std::vector<WaveComponent> travelling(const std::vector<Harmonic>& harmonics, double start,
                                      const ElevationChoice& choice, const Sea& sea,
                                      ElevationFit& fit) {
  const Eigen::Vector2d direction(std::cos(choice.heading), std::sin(choice.heading));
  const double along = sea.current.head<2>().dot(direction);
  std::vector<WaveComponent> waves;
  for (const Harmonic& h : harmonics) {
    const auto k = wave_number(h.omega, sea.depth, sea.gravity, along);
    if (!k) {
      fit.stopped += h.energy();
      continue;
    }
    // cos(k·x − ωt + φ) is cos(ω (t − start) + phase) at the gauge.
    const double phase = h.omega * start - h.phase - *k * direction.dot(choice.at);
    waves.push_back({.amplitude = h.amplitude,
                     .kx = *k * direction.x(),
                     .ky = *k * direction.y(),
                     .omega = h.omega,
                     .phase = std::remainder(phase, 2 * M_PI)});
  }
  return waves;
}

/// Turns energies into parts of that of the record.
void normalise(double energy, ElevationFit& fit) {
  for (double* part : {&fit.below, &fit.above, &fit.dropped, &fit.stopped}) *part /= energy;
  fit.residual = std::sqrt(fit.below + fit.above + fit.dropped + fit.stopped);
}

}  // namespace

MeasuredSea sea_of_record(const ElevationRecord& record, const ElevationChoice& choice,
                          const Sea& sea) {
  MeasuredSea result;
  ElevationFit& fit = result.fit;
  fit.mean = mean_of(record.elevations);
  double energy = 0;
  for (const double elevation : record.elevations)
    energy += (elevation - fit.mean) * (elevation - fit.mean);
  energy /= static_cast<double>(record.elevations.size());
  if (!(energy > 1e-24 * fit.mean * fit.mean && energy > 0))
    throw std::invalid_argument("the record is constant, expected waves");
  const std::vector<Harmonic> harmonics = harmonics_of(record);
  const double peak = smoothed_peak(harmonics);
  fit.significant_height = 4 * std::sqrt(energy);
  fit.peak_period = 2 * M_PI / peak;
  fit.jump = jump_of(record.elevations);
  fit.lowest = choice.lowest.value_or(ElevationChoice::kLowest * peak);
  fit.highest =
      choice.highest.value_or(std::min(ElevationChoice::kHighest * peak, harmonics.back().omega));
  std::vector<Harmonic> kept = in_band(harmonics, fit);
  if (kept.empty()) throw std::invalid_argument("no frequency of the record is in the band");
  fit.above += nyquist_energy(record.elevations);
  keep_largest(static_cast<std::size_t>(choice.components), kept, fit);
  result.components = travelling(kept, record.start, choice, sea, fit);
  normalise(energy, fit);
  return result;
}

}  // namespace hydro
