#include "hydro/radiation/green_function.h"

#include <gtest/gtest.h>
#include <math.h>

#include <cmath>
#include <numbers>

#include "tests/support/repeats.h"

/// The wave part of the Green function of deep water, against its integral.

namespace {

using hydro::wave_green;
using hydro::WaveGreen;
using std::numbers::pi;

/// F by quadrature.
double real_part(double x, double y) {
  return -2 * pi * std::exp(-y) * ::y0(x) - 2 * hydro::wave_green_integral(x, y);
}

TEST(WaveGreen, IsThatOfItsIntegralNearAndFar) {
  const int steps = support::repeats(40);
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j < steps; ++j) {
      // From a thousandth of a wave's radian to a hundred; from the surface to 0.1° of the axis.
      const double rho = std::pow(10, -3 + 5.0 * i / steps);
      const double angle = (pi / 2 - 1e-3) * j / (steps - 1.0);
      const double x = rho * std::cos(angle), y = rho * std::sin(angle);
      if (y > 60) continue;
      const double F = real_part(x, y);
      EXPECT_NEAR(wave_green(x, y).value.real(), F, 1e-8 * (1 + std::abs(F))) << x << ' ' << y;
    }
}

TEST(WaveGreen, ItsSlopeIsThatOfItsValue) {
  for (const double rho : {0.05, 0.7, 2.0, 5.0, 9.0, 12.0, 20.0, 40.0})
    for (const double mu : {0.0, 0.3, 0.7, 0.9, 0.99}) {
      const double x = rho * std::sqrt(1 - mu * mu), y = rho * mu, h = 1e-4 * x;
      const std::complex<double> slope =
          (wave_green(x + h, y).value - wave_green(x - h, y).value) / (2 * h);
      EXPECT_LT(std::abs(wave_green(x, y).by_x - slope), 1e-5 * (1 + std::abs(slope)))
          << rho << ' ' << mu;
    }
}

TEST(WaveGreen, ObeysTheConditionOfTheFreeSurface) {
  // ∂𝒢/∂Y = −𝒢 − 2/ρ is what makes G satisfy it.
  for (const double x : {0.2, 1.5, 4.0, 11.0, 30.0})
    for (const double y : {0.1, 0.9, 3.0, 8.0}) {
      const double h = 1e-4;
      const std::complex<double> slope =
          (wave_green(x, y + h).value - wave_green(x, y - h).value) / (2 * h);
      const std::complex<double> wanted = -wave_green(x, y).value - 2 / std::hypot(x, y);
      EXPECT_LT(std::abs(slope - wanted), 1e-5 * (1 + std::abs(wanted))) << x << ' ' << y;
    }
}

TEST(WaveGreen, IsFiniteAtTheSourceItself) {
  const WaveGreen green = wave_green(0, 1e-12);
  EXPECT_TRUE(std::isfinite(green.value.real()));
  EXPECT_NEAR(green.value.imag(), 2 * pi, 1e-9);
  EXPECT_TRUE(std::isfinite(green.by_x.real()));
}

}  // namespace
