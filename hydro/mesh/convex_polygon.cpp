#include "hydro/mesh/convex_polygon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace hydro {

using Eigen::Vector3d;

std::vector<double> from_side(const Polygon& points, const Polygon& polygon, std::size_t side,
                              const Vector3d& normal, double margin) {
  const Vector3d& start = polygon[side];
  const Vector3d inward = normal.cross(polygon[(side + 1) % polygon.size()] - start).normalized();
  std::vector<double> distances;
  for (const Vector3d& p : points) {
    const double d = inward.dot(p - start);
    distances.push_back(std::abs(d) <= margin ? 0 : d);
  }
  return distances;
}

Polygon kept_part(const Polygon& polygon, const std::vector<double>& distances, int sign) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    const double from = sign * distances[i], to = sign * distances[j];
    if (from >= 0) kept.push_back(polygon[i]);
    if (from * to < 0)
      kept.emplace_back(polygon[i] + from / (from - to) * (polygon[j] - polygon[i]));
  }
  return kept;
}

double area_of(const Polygon& polygon) {
  Vector3d area = Vector3d::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i)
    area += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]) / 2;
  return area.norm();
}

bool has_area(const Polygon& polygon, double margin) {
  double perimeter = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    perimeter += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
  return polygon.size() >= 3 && area_of(polygon) > margin * perimeter;
}

Polygon convex_hull(Polygon points, const Vector3d& normal, double margin) {
  const Vector3d x = normal.unitOrthogonal(), y = normal.cross(x);
  std::ranges::sort(points, {}, [&](const Vector3d& p) { return std::pair(x.dot(p), y.dot(p)); });
  Polygon hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = hull.size();
    for (const Vector3d& p : points) {
      const auto turns_left = [&] {
        const Vector3d along = hull.back() - hull[hull.size() - 2];
        return along.cross(p - hull.back()).dot(normal) > margin * along.norm();
      };
      while (hull.size() >= first + 2 && !turns_left()) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
  return hull;
}

std::vector<Polygon> without(const std::vector<Polygon>& polygons, const Polygon& hole,
                             const Vector3d& normal, double margin) {
  std::vector<Polygon> rest;
  for (Polygon polygon : polygons)
    for (std::size_t side = 0; side < hole.size() && !polygon.empty(); ++side) {
      const std::vector<double> d = from_side(polygon, hole, side, normal, margin);
      Polygon outside = kept_part(polygon, d, -1);
      Polygon inside = kept_part(polygon, d, 1);
      if (!has_area(inside, margin)) {  // The two have nothing in common.
        rest.push_back(std::move(polygon));
        break;
      }
      if (has_area(outside, margin)) rest.push_back(std::move(outside));
      polygon = std::move(inside);
    }
  return rest;
}

}  // namespace hydro
