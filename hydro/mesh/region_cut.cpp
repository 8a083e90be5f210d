#include "hydro/mesh/region_cut.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "hydro/mesh/polygon_cut.h"

namespace hydro {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Two directions in a plane, counter-clockwise about its normal.
struct PlaneAxes {
  Vector3d along, across;

  explicit PlaneAxes(const Vector3d& normal)
      : along(normal.unitOrthogonal()), across(normal.cross(along)) {}
  Vector2d at(const Vector3d& p) const { return {along.dot(p), across.dot(p)}; }
};

double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const Vector2d u = b - a, v = c - a;
  return u.x() * v.y() - u.y() * v.x();
}

/// Joins holes to an outline, from the one farthest to the right on (D. Eberly, Triangulation by
/// ear clipping, 2002).
class Bridges {
 public:
  Bridges(const std::vector<Vector3d>& vertices, const std::vector<int>& outline,
          const Vector3d& normal)
      : vertices_(vertices), axes_(normal), ring_(outline) {}

  void join(std::vector<std::vector<int>> holes) {
    for (std::vector<int>& hole : holes)
      std::rotate(hole.begin(),
                  std::ranges::max_element(hole, {}, [&](int v) { return at(v).x(); }), hole.end());
    std::ranges::stable_sort(holes, std::ranges::greater(),
                             [&](const std::vector<int>& hole) { return at(hole[0]).x(); });
    for (const std::vector<int>& hole : holes) splice(hole, visible_from(at(hole[0])));
  }

  const std::vector<int>& ring() const { return ring_; }

 private:
  Vector2d at(int vertex) const { return axes_.at(vertices_[static_cast<std::size_t>(vertex)]); }
  Vector2d corner(std::size_t i) const { return at(ring_[i % ring_.size()]); }

  /// Returns a corner of the ring that sees a point inside it.
  std::size_t visible_from(const Vector2d& p) const {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Vector2d a = corner(i), b = corner(i + 1);
      if (std::min(a.y(), b.y()) > p.y() || std::max(a.y(), b.y()) < p.y() || a.y() == b.y())
        continue;
      const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      if (x < p.x() || x >= nearest) continue;
      nearest = x;
      best = a.x() > b.x() ? i : (i + 1) % ring_.size();
    }
    const Vector2d hit(nearest, p.y()), end = corner(best);
    double least = std::numeric_limits<double>::infinity();
    std::size_t seen = best;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Vector2d c = corner(i);
      if (c != end && !in_triangle(p, hit, end, c)) continue;
      if (!opens_towards(i, p)) continue;
      const Vector2d way = c - p;
      const double angle = std::abs(std::atan2(way.y(), way.x()));
      if (angle > least || (angle == least && way.norm() >= (corner(seen) - p).norm())) continue;
      least = angle;
      seen = i;
    }
    return seen;
  }

  static bool in_triangle(const Vector2d& a, const Vector2d& b, const Vector2d& c,
                          const Vector2d& p) {
    const double u = turn(a, b, p), v = turn(b, c, p), w = turn(c, a, p);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
  }

  /// True if a point lies in the inner angle of a corner. Bridges repeat corners, of which only one
  /// opens towards a point.
  bool opens_towards(std::size_t i, const Vector2d& p) const {
    const Vector2d c = corner(i), before = corner(i + ring_.size() - 1), after = corner(i + 1);
    const bool left_of_first = turn(before, c, p) >= 0, left_of_second = turn(c, after, p) >= 0;
    return turn(before, c, after) >= 0 ? left_of_first && left_of_second
                                       : left_of_first || left_of_second;
  }

  void splice(const std::vector<int>& hole, std::size_t corner) {
    std::vector<int> ring(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(corner) + 1);
    ring.insert(ring.end(), hole.begin(), hole.end());
    ring.push_back(hole[0]);
    ring.insert(ring.end(), ring_.begin() + static_cast<std::ptrdiff_t>(corner), ring_.end());
    ring_ = std::move(ring);
  }

  const std::vector<Vector3d>& vertices_;
  PlaneAxes axes_;
  std::vector<int> ring_;
};

}  // namespace

void cut_region(const std::vector<Vector3d>& vertices, const std::vector<int>& outline,
                std::vector<std::vector<int>> holes, const Vector3d& normal,
                std::vector<Eigen::Vector3i>& faces) {
  Bridges bridges(vertices, outline, normal);
  bridges.join(std::move(holes));
  cut_polygon(vertices, bridges.ring(), faces);
}

bool encloses(const std::vector<Vector3d>& vertices, const std::vector<int>& outline,
              const Vector3d& normal, const Vector3d& point) {
  const PlaneAxes axes(normal);
  const Vector2d p = axes.at(point);
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d a = axes.at(vertices[static_cast<std::size_t>(outline[i])]);
    const Vector2d b =
        axes.at(vertices[static_cast<std::size_t>(outline[(i + 1) % outline.size()])]);
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

}  // namespace hydro
