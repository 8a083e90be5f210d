#include "hydro/water/periodic_waves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hydro/airy_waves.h"
#include "tests/support/tolerance.h"

namespace hydro {
namespace {

using Eigen::Index;
using support::tolerance;

constexpr int kCells = 64;

/// Waves of random phases in all but the shortest modes.
PeriodicWaves random_waves(const PeriodicSquare& square) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Eigen::MatrixXcd state = Eigen::MatrixXcd::Zero(square.cells, square.cells);
  for (Index column = 0; column < 12; ++column)
    for (Index row = 0; row < 12; ++row) state(row, column) = {normal(random), normal(random)};
  state(0, 0) = 0;
  PeriodicWaves waves(square);
  waves.restore(state);
  return waves;
}

TEST(PeriodicWaves, KeepTheirEnergy) {
  PeriodicWaves waves = random_waves({.cells = kCells, .cell = 0.3});
  const double before = waves.energy();
  for (int i = 0; i < 10000; ++i) waves.advance(0.0173);
  // A product of 1e4 factors of magnitude 1, each rounded to 1e-16.
  EXPECT_NEAR(waves.energy() / before, 1, tolerance(1e-11));
}

TEST(PeriodicWaves, AreAsFarInManyStepsAsInOne) {
  PeriodicWaves many = random_waves({.cells = kCells, .cell = 0.3});
  PeriodicWaves one = many;
  for (int i = 0; i < 10000; ++i) many.advance(0.0173);
  one.advance(173);
  EXPECT_LT((many.state() - one.state()).norm(), tolerance(1e-9) * one.state().norm());
}

TEST(PeriodicWaves, HaveCrestsThatMoveWithOmegaOverK) {
  for (const double depth : {0.7, 4.0, HUGE_VAL}) {
    const PeriodicSquare square{.cells = kCells, .cell = 0.3, .depth = depth};
    const Index m = 3;
    Eigen::MatrixXcd state = Eigen::MatrixXcd::Zero(kCells, kCells);
    state(0, m) = kCells * kCells * 0.5;
    PeriodicWaves waves(square);
    waves.restore(state);
    const double k = 2 * M_PI * m / square.side();
    const double omega = intrinsic_frequency(k, depth, square.gravity);
    const double time = 11.3;
    const Eigen::MatrixXf later = waves.elevation(time);
    waves.advance(time);
    // The transform is of single precision.
    EXPECT_LT((waves.elevation() - later).cwiseAbs().maxCoeff(), tolerance(1e-6));
    for (Index column = 0; column < kCells; ++column)
      EXPECT_NEAR(later(5, column),
                  0.5 * std::cos(k * square.cell * static_cast<double>(column) - omega * time),
                  tolerance(1e-6));
  }
}

/// ŵ of a source is its volume times C(k, z) e^{−ik·x}. The layers hold it to some percent of the
/// source for the waves of three cells and more.
TEST(PeriodicWaves, AreRaisedByASourceAsMuchAsItsDepthAllows) {
  for (const double depth : {1.5, HUGE_VAL}) {
    const PeriodicSquare square{.cells = kCells, .cell = 0.25, .deepest = 1, .depth = depth};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(-100, 100), below(-1, 0);
    for (int i = 0; i < 20; ++i) {
      const double x = anywhere(random), y = anywhere(random), z = below(random), volume = 0.7;
      PeriodicWaves waves(square);
      waves.add_source(x, y, z, volume);
      waves.take_sources();
      for (Index column = 0; column < kCells / 6; ++column)
        for (Index row = column == 0 ? 1 : 0; row < kCells / 6; ++row) {
          const double kx = 2 * M_PI * static_cast<double>(column) / square.side();
          const double ky = 2 * M_PI * static_cast<double>(row) / square.side();
          const double k = std::hypot(kx, ky);
          const double held = std::isinf(depth) ? std::exp(k * z)
                                                : std::cosh(k * (z + depth)) / std::cosh(k * depth);
          const std::complex<double> expected = volume * held / (square.cell * square.cell) *
                                                std::polar(1.0, -(kx * x + ky * y) * square.cell);
          EXPECT_LT(std::abs(waves.state()(row, column) - expected),
                    tolerance(0.07) * volume / (square.cell * square.cell))
              << "k " << k << ", z " << z << ", depth " << depth;
        }
    }
  }
}

TEST(PeriodicWaves, TakeSourcesOnce) {
  PeriodicWaves waves({.cells = kCells});
  waves.add_source(3.2, -1.7, -0.2, 1);
  waves.take_sources();
  const Eigen::MatrixXcd state = waves.state();
  waves.take_sources();
  EXPECT_EQ(waves.state(), state);
}

TEST(PeriodicWaves, AreDampedWhereTheFactorIsLow) {
  PeriodicWaves waves = random_waves({.cells = kCells, .cell = 0.3});
  const Eigen::MatrixXf before = waves.elevation();
  Eigen::VectorXf half = Eigen::VectorXf::Ones(kCells);
  half.tail(kCells / 2).setZero();
  waves.damp(Eigen::VectorXf::Ones(kCells) * half.transpose());
  const Eigen::MatrixXf after = waves.elevation();
  const float unit = before.cwiseAbs().maxCoeff();
  EXPECT_LT((after.leftCols(kCells / 2) - before.leftCols(kCells / 2)).cwiseAbs().maxCoeff(),
            tolerance(1e-5) * unit);
  EXPECT_LT(after.rightCols(kCells / 2).cwiseAbs().maxCoeff(), tolerance(1e-5) * unit);
}

}  // namespace
}  // namespace hydro
