#include "hydro/loads/kernel/friction_means.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace hydro::kernel {
namespace {

using std::numbers::ln10;
using std::numbers::pi;

constexpr double kFactor = 0.075 * ln10 * ln10;

/// C_n/(K z²) at x = 1/z. With R = Re e^{−y} equation (1) is the integral of n C_v e^{−ny} over y,
/// up to Y where the line is held, and beyond it.
double mean_over_line(int n, double x) {
  constexpr int kIntervals = 100;  // of Gauss' rule of five points: its error is below 1e-12
  const double held = std::log(kLeastReynolds / 100), Y = x - held;
  const double half = std::min(Y, 40.0 / n) / (2 * kIntervals);
  double sum = 0;
  for (int i = 0; i < kIntervals; ++i)
    for (int k = -2; k <= 2; ++k) {
      const double at = kGaussAt[std::abs(k)] * (k < 0 ? -1 : 1), y = (2 * i + 1 + at) * half;
      sum += kGaussWeight[std::abs(k)] * std::exp(-n * y) / ((x - y) * (x - y));
    }
  return x * x * (n * sum * half + std::exp(-n * Y) / (held * held));
}

/// The polynomial through the values at Chebyshev's points.
std::array<double, kMeanTerms> fit(int n, double middle, double half) {
  std::array<double, kMeanTerms> sum = {}, before = {}, now = {};
  now[0] = 1;  // T_j as a polynomial
  for (int j = 0; j < kMeanTerms; ++j) {
    double c = 0;
    for (int i = 0; i < kMeanTerms; ++i) {
      const double angle = pi * (i + 0.5) / kMeanTerms;
      c += std::cos(j * angle) * mean_over_line(n, 1 / (middle + half * std::cos(angle)));
    }
    c *= (j == 0 ? 1.0 : 2.0) / kMeanTerms;
    std::array<double, kMeanTerms> next = {};
    for (int k = 0; k < kMeanTerms; ++k) {
      sum[k] += c * now[k];
      next[k] = (k > 0 ? (j == 0 ? 1 : 2) * now[k - 1] : 0.0) - before[k];
    }
    before = now;
    now = next;
  }
  return sum;
}

FrictionMeans make_means() {
  const double first = 1 / std::log(kMostReynolds / 100), last = 1 / std::log(kLeastReynolds / 100);
  FrictionMeans means{.K = kFactor, .middle = (first + last) / 2, .half = (last - first) / 2};
  means.third = fit(3, means.middle, means.half);
  means.fifth = fit(5, means.middle, means.half);
  return means;
}

}  // namespace

const FrictionMeans& friction_means() {
  static const FrictionMeans means = make_means();
  return means;
}

}  // namespace hydro::kernel
