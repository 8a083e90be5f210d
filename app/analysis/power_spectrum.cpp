#include "app/analysis/power_spectrum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "app/analysis/signal_statistics.h"

namespace app {
namespace {

using Bins = std::vector<std::complex<double>>;

/// Cuts signals into segments and transforms them.
class Segments {
 public:
  Segments(std::size_t samples, std::size_t segment)
      : segment_(segment), size_(std::bit_ceil(segment)) {
    for (std::size_t first = 0; first + segment <= samples;
         first += std::max<std::size_t>(1, segment / 2))
      starts_.push_back(first);
    for (std::size_t i = 0; i < segment; ++i) {
      const double phase =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(segment);
      window_.push_back((1 - std::cos(phase)) / 2);
      times_.push_back(static_cast<double>(i));
      energy_ += window_.back() * window_.back();
    }
    fft_.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  }

  const std::vector<std::size_t>& starts() const { return starts_; }
  std::size_t size() const { return size_; }  ///< Samples of a transform, filled up with zeros.
  double energy() const { return energy_; }   ///< Sum of the squares of the window.

  Bins transformed(const std::vector<double>& values, std::size_t start) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(start);
    std::vector<double> part =
        without_trend(times_, {first, first + static_cast<std::ptrdiff_t>(segment_)});
    for (std::size_t i = 0; i < segment_; ++i) part[i] *= window_[i];
    part.resize(size_, 0);
    Bins bins;
    fft_.fwd(bins, part);
    return bins;
  }

 private:
  std::size_t segment_;
  std::size_t size_;
  std::vector<std::size_t> starts_;
  std::vector<double> window_, times_;
  double energy_ = 0;
  Eigen::FFT<double> fft_;
};

std::vector<double> frequencies_of(std::size_t bins, double rate, std::size_t size) {
  std::vector<double> frequencies;
  for (std::size_t k = 0; k < bins; ++k)
    frequencies.push_back(static_cast<double>(k) * rate / static_cast<double>(size));
  return frequencies;
}

}  // namespace

double PowerSpectrum::moment(int n) const {
  double sum = 0;
  for (std::size_t k = 1; k < density.size(); ++k) sum += std::pow(frequencies[k], n) * density[k];
  return frequencies.size() > 1 ? sum * frequencies[1] : 0;
}

double PowerSpectrum::peak() const {
  return frequencies[static_cast<std::size_t>(std::ranges::max_element(density) - density.begin())];
}

PowerSpectrum power_spectrum(const std::vector<double>& values, double rate, std::size_t segment) {
  Segments segments(values.size(), segment);
  PowerSpectrum spectrum;
  spectrum.segments = static_cast<int>(segments.starts().size());
  spectrum.density.assign(segments.size() / 2 + 1, 0);
  spectrum.frequencies = frequencies_of(spectrum.density.size(), rate, segments.size());
  for (const std::size_t start : segments.starts()) {
    const Bins bins = segments.transformed(values, start);
    for (std::size_t k = 0; k < bins.size(); ++k) spectrum.density[k] += std::norm(bins[k]);
  }
  const double scale = 2 / (rate * segments.energy() * spectrum.segments);
  for (double& density : spectrum.density) density *= scale;
  spectrum.density.front() /= 2;  // These two have no partner of negative frequency.
  spectrum.density.back() /= 2;
  return spectrum;
}

TransferFunction transfer_function(const std::vector<double>& input,
                                   const std::vector<double>& output, double rate,
                                   std::size_t segment) {
  Segments segments(input.size(), segment);
  const std::size_t bins = segments.size() / 2 + 1;
  std::vector<double> of_input(bins), of_output(bins);
  Bins cross(bins);
  for (const std::size_t start : segments.starts()) {
    const Bins in = segments.transformed(input, start), out = segments.transformed(output, start);
    for (std::size_t k = 0; k < bins; ++k) {
      of_input[k] += std::norm(in[k]);
      of_output[k] += std::norm(out[k]);
      cross[k] += std::conj(in[k]) * out[k];
    }
  }
  const double count = static_cast<double>(segments.starts().size());
  TransferFunction transfer;
  transfer.frequencies = frequencies_of(bins, rate, segments.size());
  transfer.segments = static_cast<int>(segments.starts().size());
  for (std::size_t k = 0; k < bins; ++k) {
    const double both = of_input[k] * of_output[k];
    transfer.response.push_back(of_input[k] > 0 ? cross[k] / of_input[k] : 0);
    transfer.coherence.push_back(both > 0 ? std::norm(cross[k]) / both : 0);
    transfer.input.push_back(2 * of_input[k] / (rate * segments.energy() * count));
  }
  return transfer;
}

std::size_t usual_segment(std::size_t samples) {
  constexpr std::size_t kSegments = 8, kLeast = 8;
  return std::clamp(2 * samples / (kSegments + 1), std::min(kLeast, samples), samples);
}

}  // namespace app
