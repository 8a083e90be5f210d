#include "hydro/interior/lids.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "hydro/mesh/edge_table.h"

namespace hydro {
namespace {

using Loop = std::vector<int>;  ///< Vertices of a mesh, in the order in which the lid has them.

/// The loops along which the faces that are kept end.
std::vector<Loop> open_loops(const TriMesh& mesh, const std::vector<int>& pocket_of_face) {
  std::multimap<int, int> next;
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  for (std::size_t i = 0; i < edges.size(); i = edge_end(edges, i)) {
    int open = 0;  // Rising sides of kept faces less the falling ones.
    for (std::size_t j = i; j < edge_end(edges, i); ++j)
      if (pocket_of_face[edges[j].face] == kSea) open += edges[j].rising ? 1 : -1;
    // The lid runs against the face that it meets.
    if (open > 0) next.emplace(edges[i].high, edges[i].low);
    if (open < 0) next.emplace(edges[i].low, edges[i].high);
  }
  std::vector<Loop> loops;
  while (!next.empty()) {
    // Where the way comes back to a vertex, a loop ends.
    Loop way = {next.begin()->first};
    for (auto step = next.begin(); step != next.end(); step = next.find(way.back())) {
      const int to = step->second;
      next.erase(step);
      const auto known = std::find(way.begin(), way.end(), to);
      if (known != way.end()) {
        loops.emplace_back(known, way.end());
        way.erase(known, way.end());
      }
      way.push_back(to);
    }
  }
  return loops;
}

/// A loop in the plane of its area vector.
std::vector<Eigen::Vector2d> in_plane(const TriMesh& mesh, const Loop& loop) {
  const Eigen::Vector3d origin = mesh.vertices.col(loop[0]);
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    area += (mesh.vertices.col(loop[i]) - origin).cross(mesh.vertices.col(loop[i + 1]) - origin);
  const Eigen::Vector3d normal = area.normalized();
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Eigen::Vector2d> flat;
  for (const int i : loop) {
    const Eigen::Vector3d r = mesh.vertices.col(i) - origin;
    flat.emplace_back(u.dot(r), v.dot(r));
  }
  return flat;
}

double doubled_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d p = b - a, q = c - a;
  return p.x() * q.y() - p.y() * q.x();
}

/// Pairs of vertices that an edge of the faces connects, the lower one first.
using Edges = std::set<std::pair<int, int>>;

Edges edges_of(const std::vector<Eigen::Vector3i>& faces) {
  Edges edges;
  for (const Eigen::Vector3i& face : faces)
    for (int i = 0; i < 3; ++i) edges.insert(std::minmax(face[i], face[(i + 1) % 3]));
  return edges;
}

/// The polygon that is left of a lid while corners are cut off.
class Lid {
 public:
  Lid(const TriMesh& mesh, const Loop& loop, const Edges& taken)
      : loop_(loop), flat_(in_plane(mesh, loop)), taken_(taken), rest_(loop.size()) {
    std::iota(rest_.begin(), rest_.end(), 0);
  }

  /// Cuts off the best corner. @return false if none can be
  bool cut(std::vector<Eigen::Vector3i>& faces);
  std::vector<int> rest() const {
    std::vector<int> vertices;
    for (const int i : rest_) vertices.push_back(loop_[i]);
    return vertices;
  }

 private:
  std::array<int, 3> corner(std::size_t i) const {
    const std::size_t n = rest_.size();
    return {rest_[(i + n - 1) % n], rest_[i], rest_[(i + 1) % n]};
  }
  double merit(std::size_t i) const;

  const Loop& loop_;
  std::vector<Eigen::Vector2d> flat_;
  const Edges& taken_;
  std::vector<int> rest_;
};

/// How good a corner is to be cut off: its doubled area over its longest side squared; none if it
/// points inward, holds another corner, or if the cut is an edge already.
double Lid::merit(std::size_t i) const {
  const auto [before, here, after] = corner(i);
  const Eigen::Vector2d &a = flat_[before], &b = flat_[here], &c = flat_[after];
  const double area = doubled_area(a, b, c);
  const bool last = rest_.size() == 3;
  if (last) return 1;
  if (!(area > 0) || taken_.contains(std::minmax(loop_[before], loop_[after]))) return 0;
  for (const int k : rest_) {
    if (k == before || k == here || k == after) continue;
    if (doubled_area(a, b, flat_[k]) >= 0 && doubled_area(b, c, flat_[k]) >= 0 &&
        doubled_area(c, a, flat_[k]) >= 0)
      return 0;
  }
  return area / std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

bool Lid::cut(std::vector<Eigen::Vector3i>& faces) {
  std::size_t best = 0;
  double most = 0;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const double value = merit(i);
    if (value <= most) continue;
    most = value;
    best = i;
  }
  if (most == 0) return false;
  const auto [before, here, after] = corner(best);
  faces.emplace_back(loop_[before], loop_[here], loop_[after]);
  rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(best));
  return true;
}

/// Adds the lid of a loop to the faces. Corners that cannot be cut off become a fan around a new
/// vertex.
void add_lid(const Loop& loop, TriMesh& mesh, std::vector<Eigen::Vector3i>& faces) {
  if (loop.size() < 3) return;
  const Edges taken = edges_of(faces);
  Lid lid(mesh, loop, taken);
  while (lid.rest().size() > 2)
    if (!lid.cut(faces)) break;
  const std::vector<int> rest = lid.rest();
  if (rest.size() < 3) return;
  const int centre = static_cast<int>(mesh.vertex_count());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const int v : rest) mean += mesh.vertices.col(v) / static_cast<double>(rest.size());
  mesh.vertices.conservativeResize(3, centre + 1);
  mesh.vertices.col(centre) = mean;
  for (std::size_t i = 0; i < rest.size(); ++i)
    faces.emplace_back(rest[i], rest[(i + 1) % rest.size()], centre);
}

/// The mesh of these faces, with the vertices that they name.
TriMesh without_unused(const TriMesh& mesh, const std::vector<Eigen::Vector3i>& faces) {
  std::vector<int> place(mesh.vertex_count(), -1), used;
  TriMesh compact;
  compact.faces.resize(3, static_cast<Eigen::Index>(faces.size()));
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      int& to = place[faces[f][i]];
      if (to < 0) {
        to = static_cast<int>(used.size());
        used.push_back(faces[f][i]);
      }
      compact.faces(i, static_cast<Eigen::Index>(f)) = to;
    }
  compact.vertices.resize(3, static_cast<Eigen::Index>(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i)
    compact.vertices.col(static_cast<Eigen::Index>(i)) = mesh.vertices.col(used[i]);
  return compact;
}

}  // namespace

TriMesh with_lids(const TriMesh& mesh, const Pockets& division) {
  if (division.pockets.empty()) return mesh;
  TriMesh whole = mesh;
  std::vector<Eigen::Vector3i> faces;
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f)
    if (division.pocket_of_face[f] == kSea) faces.emplace_back(mesh.faces.col(f));
  for (const Loop& loop : open_loops(mesh, division.pocket_of_face)) add_lid(loop, whole, faces);
  return without_unused(whole, faces);
}

}  // namespace hydro
