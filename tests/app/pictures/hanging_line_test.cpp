#include "app/pictures/hanging_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hydro/mesh/primitives.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using app::hanging_line;
using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Chords fall short of arcs (hanging_line.h).
const double kChords = support::tolerance(1e-3);

double length_of(const Matrix3Xd& points) {
  double length = 0;
  for (Index i = 1; i < points.cols(); ++i) length += (points.col(i) - points.col(i - 1)).norm();
  return length;
}

TEST(HangingLine, HasItsLengthBetweenAnyEnds) {
  support::Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Vector3d from = random.vector(5), to = random.vector(5);
    const double length = (to - from).norm() * (1 + std::pow(10, random.uniform(-6, 2)));
    const Matrix3Xd points = hanging_line(from, to, length);
    EXPECT_EQ(points.leftCols<1>(), from);
    EXPECT_EQ(points.rightCols<1>(), to);
    EXPECT_NEAR(length_of(points), length, kChords * length) << i;
    EXPECT_LE(length_of(points), length * (1 + 1e-9)) << i;
  }
}

TEST(HangingLine, BetweenEndsAboveEachOtherGoesDownAndUp) {
  const Matrix3Xd points = hanging_line({1, 2, 5}, {1, 2, 3}, 6);
  EXPECT_NEAR(length_of(points), 6, kChords * 6);
  EXPECT_NEAR(points.row(2).minCoeff(), 1, kChords * 6);
  EXPECT_NEAR(hanging_line({1, 2, 3}, {1, 2, 3}, 4).row(2).minCoeff(), 1, kChords * 4);
}

TEST(HangingLine, SagsAsAParabolaWhereItIsShallow) {
  // A chord of 10 m and a length of 10(1 + 8/3 (0.01)²) sag by 1 % of the chord, to the second
  // order.
  const Matrix3Xd points = hanging_line({-5, 0, 2}, {5, 0, 2}, 10 * (1 + 8.0 / 3 * 1e-4));
  EXPECT_NEAR(points.row(2).minCoeff(), 1.9, support::tolerance(1e-3 * 0.1));
}

TEST(HangingLine, IsACatenary) {
  // z'' = (1/a) √(1 + z'²): the slope over the length from the lowest point is the same everywhere.
  const Matrix3Xd points = hanging_line({0, 0, 0}, {4, 3, 1}, 7);
  Index low = 0;
  points.row(2).minCoeff(&low);
  const double a = 1;  // scales out
  const auto slope = [&](Index i) {
    const Vector3d d = points.col(i + 1) - points.col(i);
    return a * d.z() / d.head<2>().norm();
  };
  double before = slope(0), length = 0;
  std::vector<double> curvatures;
  for (Index i = 1; i + 1 < points.cols(); ++i) {
    length = 0.5 * ((points.col(i) - points.col(i - 1)).norm() +
                    (points.col(i + 1) - points.col(i)).norm());
    if (length > 0.01) curvatures.push_back((slope(i) - before) / length);
    before = slope(i);
  }
  ASSERT_GT(curvatures.size(), 20u);
  for (const double curvature : curvatures)
    EXPECT_NEAR(curvature, curvatures.front(), support::tolerance(0.01) * curvatures.front());
}

TEST(HangingLine, ThatIsNoLongerThanItsDistanceIsStraight) {
  for (const double length : {0.0, 1.0, 5.0})
    EXPECT_EQ(hanging_line({0, 0, 0}, {3, 0, 4}, length).cols(), 2);
}

TEST(GroundHeight, OfAPlaneIsItsOwn) {
  const engine::Ground ground = engine::PlaneGround{-3};
  EXPECT_EQ(app::GroundHeight(ground).at(7, -2), -3);
  Matrix3Xd points = hanging_line({0, 0, 0}, {4, 0, 0}, 12);
  app::GroundHeight(ground).lift(points, 0.1);
  EXPECT_EQ(points.row(2).minCoeff(), -2.9);
  EXPECT_EQ(points.row(2).maxCoeff(), 0);
}

TEST(GroundHeight, OfAMeshIsThatOfItsHighestFace) {
  const engine::Ground ground =
      engine::MeshGround{hydro::translated(hydro::make_box({2, 2, 2}, 2), {1, 0, -4})};
  const app::GroundHeight height(ground);
  EXPECT_NEAR(height.at(1.3, 0.2), -3, support::tolerance(1e-12));
  EXPECT_EQ(height.at(5, 0), -std::numeric_limits<double>::infinity());
}

TEST(GroundHeight, WithoutGroundLiftsNothing) {
  const engine::Ground ground;
  Matrix3Xd points = hanging_line({0, 0, 0}, {4, 0, 0}, 12);
  const Matrix3Xd before = points;
  app::GroundHeight(ground).lift(points, 0.1);
  EXPECT_EQ(points, before);
}

}  // namespace
