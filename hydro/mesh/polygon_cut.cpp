#include "hydro/mesh/polygon_cut.h"

#include <Eigen/Geometry>

namespace hydro {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Sine of an angle below which a corner is straight and a point lies on a line.
constexpr double kStraight = 1e-10;

double cross_of(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// True if c lies left of the line from a to b, by more than round-off.
bool left(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return cross_of(b - a, c - a) > kStraight * (b - a).norm() * (c - a).norm();
}

/// True if c lies right of the line from a to b, by more than round-off.
bool right(const Vector2d& a, const Vector2d& b, const Vector2d& c) { return left(b, a, c); }

/// Rest of a polygon while corners are cut off. Its sense is counter-clockwise.
class Ring {
 public:
  explicit Ring(std::vector<Vector2d> points) : points_(std::move(points)) {
    const int n = size();
    ears_.assign(n, Ear::unknown);
    for (int i = 0; i < n; ++i) {
      before_.push_back((i + n - 1) % n);
      after_.push_back((i + 1) % n);
    }
    inward_.assign(n, false);
    for (int i = 0; i < n; ++i) judge(i);
  }

  int before(int i) const { return before_[i]; }
  int after(int i) const { return after_[i]; }

  /// True if the triangle at a corner lies inside the polygon and has an area.
  bool is_ear(int i) {
    if (ears_[i] == Ear::unknown) ears_[i] = find_ear(i) ? Ear::yes : Ear::no;
    return ears_[i] == Ear::yes;
  }

  void cut(int i) {
    after_[before_[i]] = after_[i];
    before_[after_[i]] = before_[i];
    inward_[i] = false;
    for (const int k : {before_[i], after_[i]}) {
      judge(k);
      ears_[k] = Ear::unknown;
    }
  }

  /// Forgets which corners are no ears: a corner that was in the way may have been cut off.
  void forget() { ears_.assign(ears_.size(), Ear::unknown); }

 private:
  enum class Ear : char { unknown, yes, no };

  int size() const { return static_cast<int>(points_.size()); }
  bool is_convex(int i) const { return left(points_[before_[i]], points_[i], points_[after_[i]]); }

  /// Notes whether a corner points inward or is straight: only such ones lie in others' triangles.
  void judge(int i) {
    const bool inward = !is_convex(i);
    if (inward && !inward_[i]) listed_.push_back(i);
    inward_[i] = inward;
  }

  bool find_ear(int i) {
    if (!is_convex(i)) return false;
    const Vector2d &a = points_[before_[i]], &b = points_[i], &c = points_[after_[i]];
    std::erase_if(listed_, [&](int k) { return !inward_[k]; });
    for (const int k : listed_) {
      const Vector2d& p = points_[k];
      if (p == a || p == b || p == c) continue;
      if (!right(a, b, p) && !right(b, c, p) && !right(c, a, p)) return false;
    }
    return true;
  }

  std::vector<Vector2d> points_;
  std::vector<int> before_, after_;
  std::vector<Ear> ears_;
  std::vector<char> inward_;
  std::vector<int> listed_;  ///< Corners that point inward, and some that no longer do.
};

/// Returns the corners in the mean plane of the polygon, in which they go around counter-clockwise.
std::vector<Vector2d> flattened(const std::vector<Vector3d>& vertices,
                                std::span<const int> corners) {
  const Vector3d& origin = vertices[corners[0]];
  Vector3d normal = Vector3d::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i)
    normal += (vertices[corners[i - 1]] - origin).cross(vertices[corners[i]] - origin);
  normal.stableNormalize();
  const Vector3d across = normal.unitOrthogonal(), along = across.cross(normal);
  std::vector<Vector2d> points;
  points.reserve(corners.size());
  for (const int corner : corners) {
    const Vector3d p = vertices[corner] - origin;
    points.emplace_back(along.dot(p), across.dot(p));
  }
  return points;
}

}  // namespace

void cut_polygon(const std::vector<Vector3d>& vertices, std::span<const int> corners,
                 std::vector<Eigen::Vector3i>& faces) {
  if (corners.size() == 3) {
    faces.emplace_back(corners[0], corners[1], corners[2]);
    return;
  }
  Ring ring(flattened(vertices, corners));
  const auto add = [&](int a, int b, int c) {
    faces.emplace_back(corners[a], corners[b], corners[c]);
  };
  int left_over = static_cast<int>(corners.size()), passed = 0;
  bool fresh = true, stuck = false;
  for (int at = 1; left_over > 2; at = ring.after(at)) {
    if (left_over == 3 || stuck || ring.is_ear(at)) {
      add(ring.before(at), at, ring.after(at));
      ring.cut(at);
      --left_over;
      passed = 0;
      fresh = false;
    } else if (++passed >= left_over) {
      stuck = fresh;
      ring.forget();
      fresh = true;
      passed = 0;
    }
  }
}

}  // namespace hydro
