#include "hydro/mesh/mesh_section.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hydro {
namespace {

using Eigen::Vector2d;

/// Vertices of an edge, the lower index first.
using Edge = std::pair<int, int>;

/// The cut through a face: it begins on one edge of the face and ends on another.
struct Cut {
  Edge begin, end;
  Vector2d start;  ///< [m]
  bool used = false;
};

/// The cuts through all faces, by the edges on which they begin.
std::vector<Cut> cuts(const TriMesh& mesh, int axis, double at) {
  const int first = (axis + 1) % 3, second = (axis + 2) % 3;
  std::vector<Cut> found;
  for (const auto& face : mesh.faces.colwise()) {
    Cut cut;
    int crossings = 0;
    for (int i = 0; i < 3; ++i) {
      const int from = face[i], to = face[(i + 1) % 3];
      const bool above = mesh.vertices(axis, from) >= at, next = mesh.vertices(axis, to) >= at;
      if (above == next) continue;
      ++crossings;
      const Edge edge = std::minmax(from, to);
      if (next) {
        cut.end = edge;
        continue;
      }
      cut.begin = edge;
      // From the same end of the edge, so that both of its faces get the same point.
      const auto a = mesh.vertices.col(edge.first), b = mesh.vertices.col(edge.second);
      const double t = (at - a[axis]) / (b[axis] - a[axis]);
      cut.start = {a[first] + t * (b[first] - a[first]), a[second] + t * (b[second] - a[second])};
    }
    if (crossings == 2) found.push_back(cut);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Cut& a, const Cut& b) { return a.begin < b.begin; });
  return found;
}

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

std::vector<SectionLoop> mesh_section(const TriMesh& mesh, int axis, double at) {
  std::vector<Cut> parts = cuts(mesh, axis, at);
  std::vector<SectionLoop> loops;
  for (Cut& start : parts) {
    std::vector<Vector2d> points;
    for (Cut* cut = &start; cut && !cut->used;) {
      cut->used = true;
      points.push_back(cut->start);
      auto next = std::lower_bound(parts.begin(), parts.end(), cut->end,
                                   [](const Cut& c, const Edge& edge) { return c.begin < edge; });
      while (next != parts.end() && next->begin == cut->end && next->used) ++next;
      cut = next != parts.end() && next->begin == cut->end ? &*next : nullptr;
    }
    if (points.size() < 3) continue;
    SectionLoop& loop = loops.emplace_back(2, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
      loop.col(static_cast<Eigen::Index>(i)) = points[i];
  }
  return loops;
}

double enclosed_area(const SectionLoop& loop) {
  double twice = 0;
  for (Eigen::Index i = 0; i < loop.cols(); ++i) {
    const Vector2d origin = loop.col(0);
    twice += cross(loop.col(i) - origin, loop.col((i + 1) % loop.cols()) - origin);
  }
  return twice / 2;
}

SectionLoop simplified(const SectionLoop& loop, double tolerance) {
  const Eigen::Index count = loop.cols();
  Eigen::Index corner = 0;
  (loop.row(0) + loop.row(1)).minCoeff(&corner);
  SectionLoop kept(2, count);
  kept.col(0) = loop.col(corner);
  Eigen::Index points = 1;
  for (Eigen::Index i = 1; i < count; ++i) {
    const Vector2d last = kept.col(points - 1), p = loop.col((corner + i) % count);
    const Vector2d chord = loop.col((corner + i + 1) % count) - last, way = p - last;
    const double length = chord.norm(), along = chord.dot(way);
    const double away = length > 0 ? std::abs(cross(way, chord)) / length : way.norm();
    const bool between = along >= 0 && along <= length * length;
    if (away > tolerance || !between) kept.col(points++) = p;
  }
  return points < 3 ? loop : SectionLoop(kept.leftCols(points));
}

}  // namespace hydro
