#include "hydro/loads/kernel/friction_means.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/loads/viscous_drag.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using hydro::kernel::friction_means;
using hydro::kernel::FrictionMeans;

const hydro::ViscousDrag kLine{.law = hydro::ViscousDrag::Law::ittc57, .reynolds_per_speed = 1};

/// C_n by (2).
double mean(const std::array<double, hydro::kernel::kMeanTerms>& c, double reynolds) {
  const FrictionMeans& means = friction_means();
  const double z = 1 / std::log(reynolds / 100), s = (z - means.middle) / means.half;
  double sum = 0, power = 1;
  for (const double term : c) {
    sum += term * power;
    power *= s;
  }
  return means.K * z * z * sum;
}

/// n ∫ C_v Rⁿ⁻¹ dR between two Reynolds numbers over the upper one's power, by Simpson's rule.
double integral(int n, double low, double high) {
  constexpr int kIntervals = 2000;
  double sum = 0;
  for (int i = 0; i <= kIntervals; ++i) {
    const double R = high * std::pow(low / high, static_cast<double>(i) / kIntervals);
    const double weight = i == 0 || i == kIntervals ? 1 : 2 + 2 * (i % 2);
    sum += weight * hydro::viscous_coefficient(kLine, R) * std::pow(R / high, n);
  }
  return n * sum * std::log(high / low) / (3 * kIntervals);
}

TEST(FrictionMeans, AreIntegralsOfTheLine) {
  support::Random random(61);
  for (int i = 0; i < 100; ++i) {
    const double high = std::pow(10, random.uniform(4.2, 14));
    const double low = std::max(1e4, high * std::pow(10, random.uniform(-4, -0.1)));
    for (const int n : {3, 5}) {
      const auto& c = n == 3 ? friction_means().third : friction_means().fifth;
      const double between = mean(c, high) - std::pow(low / high, n) * mean(c, low);
      EXPECT_NEAR(between, integral(n, low, high),
                  support::tolerance(2e-8) * hydro::viscous_coefficient(kLine, high))
          << n << ", Re " << low << " to " << high;
    }
  }
}

TEST(FrictionMeans, AreTheHeldCoefficientWhereTheLineIsHeld) {
  const double held = hydro::viscous_coefficient(kLine, 1);
  EXPECT_NEAR(mean(friction_means().third, 1e4), held, support::tolerance(2e-8) * held);
  EXPECT_NEAR(mean(friction_means().fifth, 1e4), held, support::tolerance(2e-8) * held);
}

}  // namespace
