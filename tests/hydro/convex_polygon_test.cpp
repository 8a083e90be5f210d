#include "hydro/mesh/convex_polygon.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

namespace {

using Eigen::Vector3d;
using hydro::area_of, hydro::convex_hull, hydro::from_side, hydro::has_area, hydro::kept_part;
using hydro::Polygon, hydro::without;

constexpr double kMargin = 1e-9;
/// Round-off of areas of about 1 m² some metres from the origin.
constexpr double kRoundOff = 1e-12;

/// A plane in no special place.
struct Plane {
  Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
  Vector3d origin = {1.7, -2.3, 0.9};

  Vector3d normal() const { return turn * Vector3d::UnitZ(); }
  Vector3d at(double x, double y) const { return origin + turn * Vector3d(x, y, 0); }
  Polygon rectangle(double x0, double y0, double x1, double y1) const {
    return {at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)};
  }
};

double sum_of_areas(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& polygon : polygons) sum += area_of(polygon);
  return sum;
}

TEST(ConvexPolygon, IsCutByALineIntoPartsOfItsArea) {
  const Plane plane;
  const Polygon square = plane.rectangle(0, 0, 1, 1);
  const Polygon cutter = {plane.at(0.25, -1), plane.at(0.75, 2), plane.at(-3, 0.5)};
  const std::vector<double> d = from_side(square, cutter, 0, plane.normal(), kMargin);
  const double left = area_of(kept_part(square, d, 1)), right = area_of(kept_part(square, d, -1));
  // The line crosses y = 0 at x = 5/12, and y = 1 at 7/12.
  EXPECT_NEAR(left, 0.5, kRoundOff);
  EXPECT_NEAR(left + right, 1, kRoundOff);
}

TEST(ConvexPolygon, HullOfPointsHoldsTheirOutermost) {
  const Plane plane;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-0.7, 0.7);
  Polygon points = plane.rectangle(-1, -1, 1, 1);
  points.push_back(plane.at(0, 1));  // on a side
  for (int i = 0; i < 50; ++i) points.push_back(plane.at(place(random), place(random)));
  std::shuffle(points.begin(), points.end(), random);
  const Polygon hull = convex_hull(points, plane.normal(), kMargin);
  ASSERT_EQ(hull.size(), 4U);
  EXPECT_NEAR(area_of(hull), 4, kRoundOff);
  EXPECT_GT((hull[1] - hull[0]).cross(hull[2] - hull[1]).dot(plane.normal()), 0);
}

TEST(ConvexPolygon, LessAnotherHasTheRestOfItsArea) {
  const Plane plane;
  const Polygon square = plane.rectangle(0, 0, 1, 1);
  struct Case {
    Polygon hole;
    double rest;
  };
  const Case cases[] = {{plane.rectangle(0.25, 0.25, 0.5, 0.75), 0.875},  // inside
                        {plane.rectangle(0.5, -1, 2, 2), 0.5},            // over three sides
                        {plane.rectangle(-1, -1, 2, 2), 0},               // all of it
                        {plane.rectangle(2, 0, 3, 1), 1},                 // apart
                        {plane.rectangle(1, 0, 2, 1), 1}};                // along a side
  for (const Case& c : cases) {
    const auto rest = without({square}, c.hole, plane.normal(), kMargin);
    EXPECT_NEAR(sum_of_areas(rest), c.rest, kRoundOff);
    EXPECT_NEAR(sum_of_areas(without(rest, c.hole, plane.normal(), kMargin)), c.rest, kRoundOff);
  }
}

TEST(ConvexPolygon, OnALineHasNoArea) {
  const Plane plane;
  EXPECT_FALSE(has_area({plane.at(0, 0), plane.at(1, 0), plane.at(2, 1e-10)}, kMargin));
  EXPECT_FALSE(has_area({plane.at(0, 0), plane.at(1, 0)}, kMargin));
  EXPECT_TRUE(has_area(plane.rectangle(0, 0, 1, 1e-6), kMargin));
}

}  // namespace
