#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "app/analysis/decay_fit.h"
#include "app/analysis/power_spectrum.h"
#include "app/analysis/signal_statistics.h"

/// Fits and spectra against closed forms.

namespace {

using std::numbers::pi;

std::vector<double> times_of(std::size_t rows, double interval) {
  std::vector<double> times;
  for (std::size_t i = 0; i < rows; ++i) times.push_back(static_cast<double>(i) * interval);
  return times;
}

template <class Function>
std::vector<double> over(const std::vector<double>& times, const Function& f) {
  std::vector<double> values;
  for (const double t : times) values.push_back(f(t));
  return values;
}

std::vector<double> noise(std::size_t rows) {
  std::mt19937 engine(3);
  std::vector<double> values;
  // Uniform, of variance 1; the standard's normal distribution is not the same everywhere.
  for (std::size_t i = 0; i < rows; ++i)
    values.push_back((static_cast<double>(engine()) / 4294967296.0 - 0.5) * std::sqrt(12.0));
  return values;
}

TEST(SignalStatistics, OfASineAreItsClosedForms) {
  const std::vector<double> t = times_of(4001, 0.01);
  const auto s = app::statistics_of(
      t, over(t, [](double x) { return 3 + 2 * std::sin(2 * pi * x / 4 - 0.3); }));
  EXPECT_NEAR(s.mean, 3, 1e-3);  // The last row is one more than ten whole periods.
  EXPECT_NEAR(s.deviation, std::sqrt(2.0), 1e-3);
  EXPECT_NEAR(s.max, 5, 1e-4);
  // The time of any of the equal maxima, to an interval of the rows.
  EXPECT_NEAR(std::fmod(s.at_max, 4), 1 + 0.3 * 4 / (2 * pi), 0.011);
  ASSERT_TRUE(s.crossings);
  EXPECT_EQ(s.crossings->count, 9);
  // The line through ten cycles of a sine is not quite level.
  EXPECT_NEAR(s.crossings->period, 4, 0.02);
  EXPECT_NEAR(s.crossings->significant, 4, 0.02);
}

TEST(SignalStatistics, SignificantIsTheMeanOfTheHighestThird) {
  // Cycles of one second with the amplitudes 1 … 7. Their line lies above the first row.
  const std::vector<double> t = times_of(701, 0.01);
  const auto x =
      over(t, [](double at) { return (std::floor(at + 1e-9) + 1) * std::sin(2 * pi * at + 1e-6); });
  const auto s = app::statistics_of(t, x);
  ASSERT_TRUE(s.crossings);
  EXPECT_EQ(s.crossings->count, 7);
  EXPECT_NEAR(s.crossings->largest, 14, 0.3);  // The line through growing cycles is not level.
  EXPECT_NEAR(s.crossings->significant, 13, 0.3);
}

TEST(DecayFit, OfALinearOscillatorIsItsPeriodAndDamping) {
  const double zeta = 0.03, omega = 2 * pi / 5, damped = omega * std::sqrt(1 - zeta * zeta);
  const std::vector<double> t = times_of(2000, 0.05);
  const auto fit =
      app::fitted_decay(t, over(t, [&](double at) {
                          return 0.7 + 2 * std::exp(-zeta * omega * at) * std::cos(damped * at);
                        }));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->period, 2 * pi / damped, 1e-3);  // Row 0 is not quite an extreme.
  EXPECT_NEAR(fit->damping_ratio, zeta, 1e-5);
  EXPECT_NEAR(fit->linear, 2 * zeta * omega, 1e-4);
  EXPECT_NEAR(fit->quadratic, 0, 1e-4);
  EXPECT_NEAR(fit->equilibrium, 0.7, 1e-3);
  for (const app::DecayCycle& cycle : fit->cycles)
    EXPECT_NEAR(cycle.decrement, 2 * pi * zeta / std::sqrt(1 - zeta * zeta), 1e-3);
}

TEST(DecayFit, TellsLinearFromQuadraticDamping) {
  // x'' + p1 x' + p2 |x'| x' + ω² x = 0 by the midpoint rule in steps of 1 ms.
  const double p1 = 0.02, p2 = 0.05, omega = 2 * pi / 4, step = 1e-3;
  const auto force = [&](double x, double v) {
    return -p1 * v - p2 * std::abs(v) * v - omega * omega * x;
  };
  std::vector<double> times, values;
  double x = 1, v = 0;
  for (int i = 0; i < 60000; ++i) {
    if (i % 20 == 0) {
      times.push_back(i * step);
      values.push_back(x);
    }
    const double mid_x = x + step / 2 * v, mid_v = v + step / 2 * force(x, v);
    x += step * mid_v;
    v += step * force(mid_x, mid_v);
  }
  const auto fit = app::fitted_decay(times, values);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->period, 4, 1e-3);
  EXPECT_NEAR(fit->linear, p1, 0.02 * p1);  // The fit is of first order in the damping.
  EXPECT_NEAR(fit->quadratic, p2, 0.02 * p2);
}

TEST(DecayFit, OfWhatDoesNotDecayIsNone) {
  const std::vector<double> t = times_of(1000, 0.1);
  EXPECT_FALSE(app::fitted_decay(t, over(t, [](double at) { return std::sin(at); })));
  EXPECT_FALSE(app::fitted_decay(t, over(t, [](double at) { return at; })));
  EXPECT_FALSE(app::fitted_decay(t, over(t, [](double) { return 1.0; })));
  EXPECT_FALSE(app::fitted_decay(t, over(t, [](double at) { return std::exp(-at); })));
  EXPECT_FALSE(app::fitted_decay(t, noise(1000)));
}

TEST(PowerSpectrum, HasTheVarianceAndThePeakOfASine) {
  const std::vector<double> t = times_of(4096, 0.1);
  const auto x = over(t, [](double at) { return 5 + 3 * std::sin(2 * pi * 0.5 * at); });
  const auto spectrum = app::power_spectrum(x, 10, app::usual_segment(x.size()));
  EXPECT_EQ(spectrum.segments, 8);
  EXPECT_NEAR(spectrum.moment(0), 4.5, 0.01);
  EXPECT_NEAR(spectrum.peak(), 0.5, 0.005);
}

TEST(PowerSpectrum, OfWhiteNoiseIsFlat) {
  const auto spectrum = app::power_spectrum(noise(1 << 16), 4, 256);
  // Density 1/(rate/2) of variance 1; 511 segments, that overlap by half: 5 % of scatter in a bin.
  double mean = 0;
  for (std::size_t k = 4; k < 124; ++k) {
    EXPECT_NEAR(spectrum.density[k], 0.5, 0.5 * 0.3);
    mean += spectrum.density[k] / 120;
  }
  EXPECT_NEAR(mean, 0.5, 0.01);
}

TEST(TransferFunction, OfALinearFilterIsItsOwn) {
  // y' = (x − y)/τ by the exact recursion of a first-order lag: y_n = c y_{n−1} + (1 − c) x_n.
  const double c = 0.8, rate = 5;
  const std::vector<double> x = noise(1 << 15);
  std::vector<double> y;
  for (const double in : x) y.push_back(y.empty() ? in : c * y.back() + (1 - c) * in);
  const auto transfer = app::transfer_function(x, y, rate, 1024);
  for (std::size_t k = 16; k < transfer.frequencies.size() - 16; k += 32) {
    const std::complex<double> z = std::polar(1.0, -2 * pi * transfer.frequencies[k] / rate);
    const std::complex<double> exact = (1 - c) / (1.0 - c * z);
    EXPECT_LT(std::abs(transfer.response[k] - exact), 0.01 * std::abs(exact) + 0.002);
    EXPECT_GT(transfer.coherence[k], 0.99);
  }
}

TEST(TransferFunction, OfSignalsThatHaveNothingInCommonIsNotCoherent) {
  const std::vector<double> x = noise(1 << 14);
  std::vector<double> y(x.rbegin(), x.rend());
  const auto transfer = app::transfer_function(x, y, 1, 512);
  double mean = 0;
  for (const double coherence : transfer.coherence) mean += coherence;
  EXPECT_LT(mean / static_cast<double>(transfer.coherence.size()), 0.1);
}

}  // namespace
