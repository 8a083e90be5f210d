#include "hydro/mesh/polygon_cut.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;
using Faces = std::vector<Eigen::Vector3i>;

Faces cut(const Points& points) {
  std::vector<int> corners(points.size());
  std::iota(corners.begin(), corners.end(), 0);
  Faces faces;
  hydro::cut_polygon(points, corners, faces);
  return faces;
}

Vector3d area_vector(const Points& points, const Eigen::Vector3i& face) {
  const Vector3d& a = points[face[0]];
  return 0.5 * (points[face[1]] - a).cross(points[face[2]] - a);
}

/// Area of a polygon in the plane z = 0 by the sum over its sides.
double area_by_sides(const Points& points) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d &a = points[i], &b = points[(i + 1) % points.size()];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum / 2;
}

/// Expects triangles that cover the polygon of the plane z = 0 once, turned into any position.
void expect_cover(const Points& flat, const Eigen::Isometry3d& X) {
  Points points;
  for (const Vector3d& p : flat) points.push_back(X * p);
  const Faces faces = cut(points);
  EXPECT_EQ(faces.size(), flat.size() - 2);
  const Vector3d normal = X.linear() * Vector3d::UnitZ();
  double sum = 0;
  for (const Eigen::Vector3i& face : faces) {
    // One that lies outside of the polygon would be counted once too often, since none is negative.
    EXPECT_GT(area_vector(points, face).dot(normal), 0) << face.transpose();
    sum += area_vector(points, face).dot(normal);
  }
  const double area = area_by_sides(flat);
  EXPECT_NEAR(sum, area, support::tolerance(1e-12 * area));
}

Eigen::Isometry3d some_pose() {
  Eigen::Isometry3d X(Eigen::AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()));
  X.translation() = Vector3d(3, -2, 7);
  return X;
}

TEST(PolygonCut, ConvexPolygonsBecomeAFanOfTheirFirstCorner) {
  const Faces faces = cut({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}});
  EXPECT_EQ(faces, (Faces{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(PolygonCut, AQuadIsCutAtItsCornerThatPointsInward) {
  const Points dart = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, 0}};
  for (std::size_t shift = 0; shift < 4; ++shift) {
    Points turned = dart;
    std::ranges::rotate(turned, turned.begin() + static_cast<std::ptrdiff_t>(shift));
    expect_cover(turned, some_pose());
  }
}

TEST(PolygonCut, ACornerOnAStraightSideGivesNoTriangleWithoutArea) {
  const Points square = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 1, 0},
                         {3, 2, 0}, {3, 3, 0}, {0, 3, 0}, {0, 1, 0}};
  for (std::size_t shift = 0; shift < square.size(); ++shift) {
    Points turned = square;
    std::ranges::rotate(turned, turned.begin() + static_cast<std::ptrdiff_t>(shift));
    expect_cover(turned, some_pose());
  }
}

TEST(PolygonCut, StarsAreCutInsideWithoutOverlap) {
  support::Random random(5);
  for (int corners = 4; corners < 60; ++corners) {
    Points star;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      const double radius = random.uniform(0.2, 2);
      star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    expect_cover(star, some_pose());
  }
}

TEST(PolygonCut, ACombOfManyTeethIsCut) {
  Points comb = {{1000, -1, 0}, {1000, 0, 0}};
  for (int i = 999; i > 0; --i) comb.emplace_back(i, i % 2 == 0 ? 0 : 5, 0);
  comb.emplace_back(0, 0, 0);
  comb.emplace_back(0, -1, 0);
  expect_cover(comb, some_pose());
}

TEST(PolygonCut, APolygonThatCrossesItselfOrHasNoAreaIsCutIntoAsManyTriangles) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}}).size(), 3u);
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).size(), 2u);
  EXPECT_EQ(cut({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).size(), 2u);
}

}  // namespace
