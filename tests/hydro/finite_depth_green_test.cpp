#include "hydro/radiation/finite_depth_green.h"

#include <gtest/gtest.h>
#include <math.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "hydro/airy_waves.h"
#include "hydro/radiation/green_function.h"
#include "tests/support/repeats.h"

/// The waves of a source in water of finite depth, against John's series and the conditions at
/// surface and bottom.

namespace {

using hydro::FiniteDepthGreen;
using hydro::SmoothGreen;
using std::numbers::pi;
using Complex = std::complex<double>;

/// Two points of water of the depth 1.
struct Points {
  double distance, z_x, z_y;
};

Points random_points(std::mt19937& random, double reach, double draught) {
  std::uniform_real_distribution<double> share(0, 1);
  const double distance = 0.2 + (reach - 0.2) * share(random);
  const double z_x = -draught * share(random);
  return {distance, z_x, -draught * share(random)};
}

/// G by John's series of modes (Wehausen and Laitone, eq. 13.19) in water of the depth 1. It
/// converges where the points are apart.
Complex by_modes(double K, const Points& p) {
  const double k = hydro::wave_number(std::sqrt(K), 1, 1).value();
  const double c = (k * k - K * K) / (k * k - K * K + K);
  Complex sum = 2 * pi * c * std::cosh(k * (p.z_x + 1)) * std::cosh(k * (p.z_y + 1)) *
                Complex(-::y0(k * p.distance), ::j0(k * p.distance));
  for (int n = 1; n * pi * p.distance < 40; ++n) {
    double low = (n - 0.5) * pi, high = n * pi;  // of q tan q = −K
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (middle * std::tan(middle) + K < 0 ? low : high) = middle;
    }
    const double q = low;
    sum += 4 * (q * q + K * K) / (q * q + K * K - K) * std::cos(q * (p.z_x + 1)) *
           std::cos(q * (p.z_y + 1)) * std::cyl_bessel_k(0, q * p.distance);
  }
  return sum;
}

double images(const Points& p) {
  return 1 / std::hypot(p.distance, p.z_x - p.z_y) + 1 / std::hypot(p.distance, p.z_x + p.z_y) +
         1 / std::hypot(p.distance, p.z_x + p.z_y + 2);
}

TEST(FiniteDepthGreen, IsJohnsSeries) {
  std::mt19937 random(1);
  for (const double K : {0.01, 0.3, 1.0, 3.0, 8.0})
    for (const double reach : {0.5, 3.0, 20.0}) {
      const double draught = 0.9;
      const FiniteDepthGreen green(K, 1, reach, draught);
      for (int i = 0; i < support::repeats(40); ++i) {
        const Points p = random_points(random, reach, draught);
        const Complex wanted = by_modes(K, p);
        const Complex found = green.at(p.distance, p.z_x, p.z_y).value + images(p);
        EXPECT_LT(std::abs(found - wanted), 1e-7 * (1 + std::abs(wanted)))
            << K << ' ' << p.distance << ' ' << p.z_x << ' ' << p.z_y;
      }
    }
}

TEST(FiniteDepthGreen, ItsSlopesAreThoseOfItsValue) {
  std::mt19937 random(2);
  for (const double K : {0.2, 1.0, 6.0, 40.0}) {
    const FiniteDepthGreen green(K, 1, 3, 0.8);
    for (int i = 0; i < support::repeats(40); ++i) {
      const Points p = random_points(random, 3, 0.8);
      const double h = 1e-5;
      const SmoothGreen at = green.at(p.distance, p.z_x, p.z_y);
      const Complex across = (green.at(p.distance + h, p.z_x, p.z_y).value -
                              green.at(p.distance - h, p.z_x, p.z_y).value) /
                             (2 * h);
      EXPECT_LT(std::abs(at.by_distance - across), 1e-6 * (1 + std::abs(across))) << K;
      if (p.z_y > -h) continue;
      const Complex up = (green.at(p.distance, p.z_x, p.z_y + h).value -
                          green.at(p.distance, p.z_x, p.z_y - h).value) /
                             (2 * h) -
                         2 * K / std::hypot(p.distance, p.z_x + p.z_y);
      EXPECT_LT(std::abs(at.by_height - up), 1e-6 * (1 + std::abs(up))) << K;
    }
  }
}

TEST(FiniteDepthGreen, IsThatOfDeepWaterFarFromTheBottom) {
  const double K = 0.5, depth = 60;  // Kh = 30
  const FiniteDepthGreen green(K, depth, 5, 2);
  for (const double distance : {0.1, 1.0, 4.0})
    for (const double z : {-0.1, -1.0, -1.9}) {
      const SmoothGreen found = green.at(distance, z, -0.5);
      const hydro::WaveGreen deep = hydro::wave_green(K * distance, -K * (z - 0.5));
      // The bottom's image and those of it in the surface are left.
      EXPECT_LT(std::abs(found.value - K * deep.value), 2.0 / depth);
      EXPECT_LT(std::abs(found.by_distance - K * K * deep.by_x), 1.0 / (depth * depth));
      EXPECT_NEAR(found.value.imag(), K * deep.value.imag(), 1e-12);
    }
}

TEST(FiniteDepthGreen, WithoutWavesIsZeroOnTheSurface) {
  std::mt19937 random(3);
  const FiniteDepthGreen green(std::numeric_limits<double>::infinity(), 1, 3, 0.9);
  for (int i = 0; i < support::repeats(40); ++i) {
    Points p = random_points(random, 3, 0.9);
    p.z_x = 0;  // 1/r and −1/r' cancel.
    const SmoothGreen at = green.at(p.distance, p.z_x, p.z_y);
    EXPECT_NEAR(at.value.real() + 1 / std::hypot(p.distance, p.z_y + 2), 0, 1e-9);
    EXPECT_EQ(at.value.imag(), 0);
  }
}

}  // namespace
