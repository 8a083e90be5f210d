#include "hydro/tabulated_spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "hydro/wave_spectrum.h"
#include "tests/support/tolerance.h"

namespace {

using hydro::Sea;
using hydro::TabulatedSpectrum;
using hydro::WaveComponent;
using support::tolerance;

const Sea kDeepSea{.gravity = 9.80665};

/// A JONSWAP spectrum of H_s = 4√`energy` and T_p = 8 s, from 0.3 to 20 ω_p in equal ratios.
TabulatedSpectrum jonswap_table(double energy, int rows) {
  const double peak = 2 * M_PI / 8;
  TabulatedSpectrum table;
  for (int i = 0; i < rows; ++i) {
    const double ratio = 0.3 * std::pow(20 / 0.3, static_cast<double>(i) / (rows - 1));
    table.frequencies.push_back(ratio * peak);
    table.densities.push_back(hydro::jonswap_shape(ratio, 1, 3.3));
  }
  // Simpson's rule over log ω for the scale, apart from the rule of the table.
  double sum = 0;
  for (int i = 0; i < rows; ++i)
    sum += (i == 0 || i == rows - 1 ? 1
            : i % 2 == 1            ? 4
                                    : 2) *
           table.frequencies[i] * table.densities[i];
  sum *= std::log(20 / 0.3) / (rows - 1) / 3;
  for (double& density : table.densities) density *= energy / sum;
  return table;
}

double energy_of(const std::vector<WaveComponent>& waves) {
  return std::accumulate(waves.begin(), waves.end(), 0.0, [](double sum, const WaveComponent& w) {
    return sum + w.amplitude * w.amplitude / 2;
  });
}

TEST(TabulatedSpectrum, WavesHaveTheEnergyOfTheTableToRoundOff) {
  for (const int components : {1, 7, 64, 1000}) {
    TabulatedSpectrum table = jonswap_table(0.3, 51);
    table.components = components;
    const auto waves = hydro::tabulated_sea(table, kDeepSea).components;
    ASSERT_EQ(waves.size(), static_cast<std::size_t>(components));
    EXPECT_NEAR(energy_of(waves) / hydro::spectral_energy(table), 1, tolerance(1e-13));
  }
}

TEST(TabulatedSpectrum, ATableOfJonswapHasTheHeightAndPeriodOfJonswap) {
  // The trapezoidal rule of the table has an error that falls with the rows.
  const auto error = [](int rows) {
    return std::abs(4 * std::sqrt(hydro::spectral_energy(jonswap_table(0.25, rows))) / 2 - 1);
  };
  EXPECT_LT(error(4001), tolerance(1e-6));
  EXPECT_LT(error(51), 0.01);
  const TabulatedSpectrum table = jonswap_table(0.25, 4001);
  EXPECT_NEAR(hydro::peak_frequency(table) * 8 / (2 * M_PI), 1, 2e-3);  // a row
}

TEST(TabulatedSpectrum, WavesLieWhereTheEnergyDoes) {
  // Each of N equal bands has one wave, so that below any frequency they have the energy of the
  // table but for one wave.
  TabulatedSpectrum table = jonswap_table(0.3, 201);
  table.components = 100;
  const auto waves = hydro::tabulated_sea(table, kDeepSea).components;
  for (std::size_t row = 1; row < table.frequencies.size(); ++row) {
    TabulatedSpectrum lower = table;
    lower.frequencies.resize(row + 1);
    lower.densities.resize(row + 1);
    const auto below = std::count_if(waves.begin(), waves.end(), [&](const WaveComponent& w) {
      return w.omega < table.frequencies[row];
    });
    const double expected = 100 * hydro::spectral_energy(lower) / hydro::spectral_energy(table);
    EXPECT_NEAR(static_cast<double>(below), expected, 1 + 1e-9);
  }
}

TEST(TabulatedSpectrum, AConstantDensityDoesNotRepeat) {
  // The waves' correlation over a lag is |Σ exp(iωτ)|/N. At the mean frequencies of bands of 0.01
  // rad/s it would be 1 after 628 s; random ones have one like that of as many random numbers.
  TabulatedSpectrum table;
  table.frequencies = {0.5, 1.5};
  table.densities = {1, 1};
  table.components = 100;
  const auto waves = hydro::tabulated_sea(table, kDeepSea).components;
  double largest = 0;
  for (double lag = 60; lag < 3 * 3600; lag += 0.5) {
    std::complex<double> sum = 0;
    for (const WaveComponent& w : waves) sum += std::polar(1.0, w.omega * lag);
    largest = std::max(largest, std::abs(sum) / 100);
  }
  EXPECT_LT(largest, 0.45);
}

TEST(TabulatedSpectrum, JonswapDoesNotRepeatEither) {
  // Its bands differ in width, so that their mean frequencies do.
  const auto waves = hydro::jonswap_sea({}, kDeepSea).components;
  double largest = 0;
  for (double lag = 60; lag < 3 * 3600; lag += 0.5) {
    std::complex<double> sum = 0;
    for (const WaveComponent& w : waves) sum += std::polar(1.0, w.omega * lag);
    largest = std::max(largest, std::abs(sum) / static_cast<double>(waves.size()));
  }
  EXPECT_LT(largest, 0.5);
}

TEST(TabulatedSpectrum, HeadingsTurnTheShortWayBetweenRows) {
  TabulatedSpectrum table;
  table.frequencies = {0.5, 1.5};
  table.densities = {1, 1};
  table.headings = {170 * M_PI / 180, -170 * M_PI / 180};
  table.heading = M_PI / 2;
  for (const WaveComponent& w : hydro::tabulated_sea(table, kDeepSea).components) {
    const double heading = std::atan2(w.ky, w.kx);
    const double expected = (260 + 20 * (w.omega - 0.5)) * M_PI / 180;
    EXPECT_NEAR(std::remainder(heading - expected, 2 * M_PI), 0, tolerance(1e-12));
  }
}

TEST(TabulatedSpectrum, ObeysTheDispersionRelationOfTheDepth) {
  const Sea sea{.gravity = 9.80665, .depth = 4, .current = {0.3, -0.2, 0}};
  TabulatedSpectrum table = jonswap_table(0.02, 101);
  table.spreading = 4;
  for (const WaveComponent& w : hydro::tabulated_sea(table, sea).components) {
    const double k = std::hypot(w.kx, w.ky);
    const double sigma = w.omega - w.kx * 0.3 + w.ky * 0.2;
    EXPECT_NEAR(sigma * sigma / (9.80665 * k * std::tanh(4 * k)), 1, tolerance(1e-13));
  }
}

TEST(TabulatedSpectrum, TheSameSeedIsTheSameSea) {
  const auto phases = [](int seed) {
    TabulatedSpectrum table = jonswap_table(0.3, 51);
    table.seed = seed;
    std::vector<double> all;
    for (const auto& w : hydro::tabulated_sea(table, kDeepSea).components) all.push_back(w.phase);
    return all;
  };
  EXPECT_EQ(phases(1), phases(1));
  EXPECT_NE(phases(1), phases(2));
}

TEST(TabulatedSpectrum, NumbersBeyondAllWavesAreRefused) {
  TabulatedSpectrum table;
  table.frequencies = {1, 2};
  table.densities = {0, 0};
  EXPECT_THROW(hydro::tabulated_sea(table, kDeepSea), std::invalid_argument);
  table.densities = {1, 1};
  EXPECT_THROW(hydro::tabulated_sea(table, {.gravity = 0}), std::invalid_argument);
}

}  // namespace
