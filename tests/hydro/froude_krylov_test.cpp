#include "hydro/radiation/froude_krylov.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/mesh/primitives.h"
#include "hydro/radiation/radiation_solve.h"

namespace {

using hydro::Loads6cd;

/// A box of 4 x 2 x 1 m with its centre 0.1 m below the water, in closed form: heave and surge.
TEST(FroudeKrylovForce, IsExactOnABox) {
  const double g = 9.81, depth = 0.6, height = -0.1;
  for (const double h : {std::numeric_limits<double>::infinity(), 2.0}) {
    const std::vector<double> frequencies = {0.8, 2, 4};
    const std::vector<double> headings = {0, M_PI / 3};
    const auto X = hydro::froude_krylov(hydro::make_box({4, 2, 1}), {.height = height},
                                        {.gravity = g, .depth = h}, frequencies, headings);
    for (std::size_t f = 0; f < frequencies.size(); ++f) {
      double k = frequencies[f] * frequencies[f] / g;
      for (int i = 0; i < 200 && std::isfinite(h); ++i)
        k = frequencies[f] * frequencies[f] / (g * std::tanh(k * h)) * 0.5 + 0.5 * k;
      for (Eigen::Index c = 0; c < 2; ++c) {
        const double kx = k * std::cos(headings[static_cast<std::size_t>(c)]),
                     ky = k * std::sin(headings[static_cast<std::size_t>(c)]);
        const auto half = [](double q, double a) {
          return std::abs(q) < 1e-9 ? a : std::sin(q * a) / q;
        };
        const bool deep = std::isinf(h);
        const double at_keel =
            deep ? std::exp(-k * depth) : std::cosh(k * (h - depth)) / std::cosh(k * h);
        const double over_side =
            deep ? (1 - std::exp(-k * depth)) / k
                 : (std::sinh(k * h) - std::sinh(k * (h - depth))) / (k * std::cosh(k * h));
        const double heave = g * at_keel * 4 * half(kx, 2) * half(ky, 1);
        const double surge = -g * over_side * 2 * half(ky, 1) * 2 * std::sin(2 * kx);
        EXPECT_NEAR(X[f](2, c).real(), heave, 1e-5 * g * 8);
        EXPECT_NEAR(X[f](2, c).imag(), 0, 1e-5 * g * 8);
        EXPECT_NEAR(X[f](0, c).imag(), surge, 1e-5 * g * 8);
      }
    }
  }
}

TEST(FroudeKrylovForce, IsThatOfTheSolver) {
  const hydro::TriMesh mesh = hydro::make_icosphere(1, 3);
  const auto solved = hydro::solve_radiation(mesh, {.height = 0.2}, {},
                                             {.frequencies = {2, 3}, .headings = 8, .patches = 60});
  const auto X = hydro::froude_krylov(mesh, {.height = 0.2}, {}, solved.data.frequencies,
                                      solved.data.headings);
  for (std::size_t f = 0; f < 2; ++f)
    EXPECT_LT((X[f] - solved.data.froude_krylov[f]).cwiseAbs().maxCoeff(), 0.01 * 9.81 * M_PI);
}

}  // namespace
