#include "hydro/wave_spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tests/support/tolerance.h"

namespace {

using hydro::JonswapSpectrum;
using hydro::Sea;
using support::tolerance;

constexpr double kGravity = 9.80665;
constexpr double kDeep = std::numeric_limits<double>::infinity();

/// Wave number by bisection of ω² = g k tanh kh.
double bisected_wave_number(double omega, double depth) {
  double low = 0, high = omega * omega / kGravity + omega / std::sqrt(kGravity * depth);
  for (int i = 0; i < 200; ++i) {
    const double k = (low + high) / 2;
    (kGravity * k * std::tanh(k * depth) < omega * omega ? low : high) = k;
  }
  return (low + high) / 2;
}

/// Kitaigorodskii's factor as he defines it, with ∂k/∂ω by central differences.
double defined_depth_factor(double omega, double depth) {
  const double step = 1e-4 * omega;
  const double slope =
      (bisected_wave_number(omega + step, depth) - bisected_wave_number(omega - step, depth)) /
      (2 * step);
  const double k = bisected_wave_number(omega, depth), deep = omega * omega / kGravity;
  return std::pow(k, -3) * slope / (std::pow(deep, -3) * 2 * omega / kGravity);
}

/// S(ω) without its scale.
double density(double omega, const JonswapSpectrum& spectrum, double depth) {
  const double r = omega * spectrum.peak_period / (2 * M_PI);
  const double width = r <= 1 ? 0.07 : 0.09;
  const double peak = std::exp(-0.5 * std::pow((r - 1) / width, 2));
  return std::pow(r, -5) * std::exp(-1.25 / std::pow(r, 4)) * std::pow(spectrum.gamma, peak) *
         (spectrum.tma ? defined_depth_factor(omega, depth) : 1);
}

/// Simpson's rule over log ω from 0.3 to 20 ω_p, below which lies exp(−150) of the energy.
double integral(const std::function<double(double)>& f, double peak_period) {
  const int steps = 6000;
  const double peak = 2 * M_PI / peak_period;
  const double first = std::log(0.3 * peak), width = std::log(20 / 0.3) / steps;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double omega = std::exp(first + i * width);
    sum += (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2) * omega * f(omega);
  }
  return sum * width / 3;
}

double moment_ratio(const JonswapSpectrum& spectrum, double depth) {
  const auto S = [&](double omega) { return density(omega, spectrum, depth); };
  return integral([&](double omega) { return omega * S(omega); }, spectrum.peak_period) /
         integral(S, spectrum.peak_period);
}

/// m_0 [m^2] and m_1/m_0 [rad/s] of a set of waves.
std::pair<double, double> moments(const hydro::WaveSurface& waves) {
  double m0 = 0, m1 = 0;
  for (const hydro::WaveComponent& w : waves.components) {
    m0 += w.amplitude * w.amplitude / 2;
    m1 += w.amplitude * w.amplitude / 2 * w.omega;
  }
  return {m0, m1 / m0};
}

TEST(WaveSpectrum, WavesHaveTheHeightAndTheMeanFrequencyOfTheFormula) {
  for (const bool tma : {false, true})
    for (const double gamma : {1.0, 3.3, 6.0})
      for (const double depth : {6.0, 20.0, 80.0}) {
        const JonswapSpectrum spectrum{.significant_height = 1.3,
                                       .peak_period = 8,
                                       .gamma = gamma,
                                       .tma = tma,
                                       .components = 50};
        const auto [m0, mean] =
            moments(hydro::jonswap_sea(spectrum, {.gravity = kGravity, .depth = depth}));
        EXPECT_NEAR(4 * std::sqrt(m0), 1.3, tolerance(1e-12));
        // The sea's midpoint rule has an error below 1e-6.
        const double exact = moment_ratio(spectrum, depth);
        EXPECT_NEAR(mean / exact, 1, tolerance(1e-6))
            << "tma " << tma << ", gamma " << gamma << ", depth " << depth;
      }
}

TEST(WaveSpectrum, WithoutPeakHasTheMeanFrequencyOfPiersonAndMoskowitz) {
  // ∫ω S / ∫S = Γ(3/4) B^(1/4) for S = ω^-5 exp(−B/ω^4); the part above 20 ω_p is 2e-4 of m_1.
  const double exact = std::tgamma(0.75) * std::pow(1.25, 0.25) * 2 * M_PI / 8;
  const auto [m0, mean] = moments(
      hydro::jonswap_sea({.peak_period = 8, .gamma = 1, .components = 7}, {.gravity = kGravity}));
  EXPECT_NEAR(mean / exact, 1, tolerance(3e-4));
}

TEST(WaveSpectrum, DepthFactorIsThatOfItsDefinition) {
  for (const double depth : {0.5, 10.0, 300.0})
    for (const double omega : {0.2, 0.7, 1.5, 4.0})
      EXPECT_NEAR(hydro::depth_factor(omega, depth, kGravity) / defined_depth_factor(omega, depth),
                  1,
                  tolerance(1e-7));  // central differences
}

TEST(WaveSpectrum, DepthFactorHasTheLimitsOfShallowAndDeepWater) {
  // φ → ω²h/2g in shallow water, with an error of that order, and 1 in deep water.
  const double x = 1e-6;
  EXPECT_NEAR(hydro::depth_factor(std::sqrt(x), 1, 1) / (x / 2), 1, tolerance(1e-6));
  EXPECT_EQ(hydro::depth_factor(3, 1000, kGravity), 1);
  EXPECT_EQ(hydro::depth_factor(3, kDeep, kGravity), 1);
}

TEST(WaveSpectrum, TmaTendsToJonswapAsTheWaterDeepens) {
  const auto difference = [](double depth) {
    const Sea sea{.gravity = kGravity, .depth = depth};
    const auto jonswap = hydro::jonswap_sea({.peak_period = 8}, sea).components;
    const auto tma = hydro::jonswap_sea({.peak_period = 8, .tma = true}, sea).components;
    double largest = 0;
    for (std::size_t i = 0; i < tma.size(); ++i)
      largest = std::max(largest, std::abs(tma[i].omega - jonswap[i].omega));
    return largest;
  };
  EXPECT_GT(difference(10), 0.02);
  EXPECT_LT(difference(50), 0.1 * difference(10));
  EXPECT_LT(difference(200), 1e-3 * difference(10));
  EXPECT_EQ(difference(kDeep), 0);
}

TEST(WaveSpectrum, TmaHasLessOfTheLongWaves) {
  const Sea sea{.gravity = kGravity, .depth = 5};
  const double jonswap = moments(hydro::jonswap_sea({.peak_period = 8}, sea)).second;
  EXPECT_GT(moments(hydro::jonswap_sea({.peak_period = 8, .tma = true}, sea)).second,
            1.05 * jonswap);
}

TEST(WaveSpectrum, UsualGammaFollowsSteepness) {
  EXPECT_EQ(hydro::usual_gamma(4, 6), 5);    // 3
  EXPECT_EQ(hydro::usual_gamma(4, 7.2), 5);  // 3.6
  EXPECT_EQ(hydro::usual_gamma(1, 4.2), std::exp(5.75 - 1.15 * 4.2));
  EXPECT_NEAR(hydro::usual_gamma(9, 12.6), 2.5093, tolerance(5e-5));  // 4.2
  EXPECT_EQ(hydro::usual_gamma(4, 10), 1);                            // 5
  EXPECT_EQ(hydro::usual_gamma(1, 20), 1);
  // The branches meet to half a percent at both ends.
  EXPECT_NEAR(hydro::usual_gamma(1, 3.6 + 1e-9), 5, 0.005);
  EXPECT_NEAR(hydro::usual_gamma(1, 5 - 1e-9), 1, 0.005);
}

TEST(WaveSpectrum, NumbersBeyondAllWavesAreRefused) {
  EXPECT_THROW(hydro::jonswap_sea({.peak_period = 1e-200}, {.gravity = kGravity}),
               std::invalid_argument);
  EXPECT_THROW(hydro::jonswap_sea({}, {.gravity = 0}), std::invalid_argument);
}

}  // namespace
