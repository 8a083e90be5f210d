#include "engine/motion/acceleration_history.h"

#include <functional>

#include "tests/engine/prelude.h"

namespace {

using engine::AccelerationHistory;
using engine::Vector6d;

constexpr double kRadius = 0.7;

/// A history of accelerations f(t) halfway through substeps of these lengths; the last ends at 0.
AccelerationHistory history(const std::vector<double>& substeps,
                            const std::function<Vector6d(double)>& acceleration) {
  AccelerationHistory accelerations;
  double time = 0;
  for (const double h : substeps) time -= h;
  for (const double h : substeps) {
    accelerations.add(acceleration(time + h / 2), h, kRadius);
    time += h;
  }
  return accelerations;
}

Vector6d six(double a) { return a * Vector6d::LinSpaced(1, 6); }

TEST(AccelerationHistory, GoesOnAlongALine) {
  const auto line = [](double t) { return six(2 - 3 * t); };
  EXPECT_LT((history({0.1, 0.02, 0.05}, line).expected(0.3) - line(0.3)).norm(), tolerance(1e-13));
  EXPECT_EQ(history({0.1}, line).expected(0.3), line(-0.05));
  EXPECT_EQ(AccelerationHistory().expected(0.3), Vector6d(Vector6d::Zero()));
}

TEST(AccelerationHistory, OfOneGoesOnByTheSlopeThatWasSet) {
  AccelerationHistory accelerations = history({0.1}, [](double) { return six(2); });
  accelerations.set_slope(six(5));
  EXPECT_LT((accelerations.expected(0.3) - six(2 + 5 * 0.35)).norm(), tolerance(1e-14));
}

TEST(AccelerationHistory, TrendIsThatOfAParabolaWhateverThePieces) {
  const auto parabola = [](double t) { return six(2 - 3 * t + 4 * t * t); };
  const AccelerationHistory::Trend trend = history({0.3, 0.1, 0.02, 0.05}, parabola).trend();
  EXPECT_LT((trend.value - six(2)).norm(), tolerance(1e-12));
  EXPECT_LT((trend.slope - six(-3)).norm(), tolerance(1e-11));
}

TEST(AccelerationHistory, PaceOfAnOscillationIsItsFrequency) {
  for (const double phase : {0.0, 0.4, 1.1, 2.5}) {
    const double omega = 3, h = 0.04;
    const AccelerationHistory accelerations = history(
        std::vector<double>(30, h), [&](double t) { return six(std::sin(omega * t + phase)); });
    EXPECT_TRUE(accelerations.resolved());
    // Remembered from the last extreme, a quarter of a period or 13 substeps ago at most; the
    // second difference is (ωh)²/12 low.
    EXPECT_LT(accelerations.dominant_frequency(), omega * (1 + tolerance(1e-12)));
    EXPECT_GT(accelerations.dominant_frequency(), omega * std::pow(0.9, 13) * 0.99);
  }
}

TEST(AccelerationHistory, IsNotResolvedWhereALoadSetsIn) {
  const auto step = [](double t) { return six(t < -0.1 ? 0.0 : 1.0); };
  EXPECT_FALSE(history({0.1, 0.1, 0.1}, step).resolved());
  EXPECT_EQ(history({0.1, 0.1, 0.1}, step).dominant_frequency(), 0);
  EXPECT_FALSE(history({0.1, 0.1}, step).resolved());
}

TEST(AccelerationHistory, KnowsNothingOnceItIsCleared) {
  AccelerationHistory accelerations = history({0.1, 0.1, 0.1}, [](double t) { return six(1 + t); });
  EXPECT_TRUE(accelerations.resolved());
  accelerations.clear();
  EXPECT_TRUE(accelerations.empty());
  EXPECT_FALSE(accelerations.resolved());
}

}  // namespace
