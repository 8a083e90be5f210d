#include "hydro/mesh/mending/turn_faces.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hydro/mesh/edge_table.h"
#include "hydro/mesh/face_tree.h"
#include "hydro/mesh/mesh_overlap.h"
#include "hydro/mesh/mesh_parts.h"
#include "hydro/mesh/open_loops.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// Volume that an open part encloses, over its area times its extent, below which it has no inside.
constexpr double kNoInside = 1e-6;

/// A face across an edge, and whether both must have the same turn.
struct Neighbour {
  int face;
  bool agrees;
};

/// Returns the neighbours of each face across edges with two faces.
std::vector<std::vector<Neighbour>> neighbours_of(const TriMesh& mesh) {
  std::vector<std::vector<Neighbour>> neighbours(static_cast<std::size_t>(mesh.face_count()));
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  for (std::size_t i = 0; i < edges.size();) {
    const std::size_t end = edge_end(edges, i);
    if (end - i == 2) {
      const HalfEdge &a = edges[i], &b = edges[i + 1];
      neighbours[a.face].push_back({b.face, a.rising != b.rising});
      neighbours[b.face].push_back({a.face, a.rising != b.rising});
    }
    i = end;
  }
  return neighbours;
}

void turn_over(TriMesh& mesh, int face) { std::swap(mesh.faces(1, face), mesh.faces(2, face)); }

/// Sign, number and measures of the faces of a part.
struct PartMeasures {
  double volume = 0;  ///< With its loops filled from their middles [m^3].
  double area = 0;    ///< [m^2]
  Eigen::AlignedBox3d box;
  Vector3d origin = Vector3d::Zero();

  /// +1 or −1 if the faces look out or in, 0 if there is no inside.
  int sense() const {
    if (std::abs(volume) <= kNoInside * area * box.diagonal().norm()) return 0;
    return volume > 0 ? 1 : -1;
  }
  void add(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    volume += (a - origin).dot((b - origin).cross(c - origin)) / 6;
  }
};

std::vector<PartMeasures> measured_parts(const TriMesh& mesh, const std::vector<int>& part_of_face,
                                         const OpenBorder& border) {
  std::vector<PartMeasures> parts;
  const auto at = [&](int v) { return Vector3d(mesh.vertices.col(v)); };
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (part_of_face[f] < 0) continue;
    const auto p = static_cast<std::size_t>(part_of_face[f]);
    if (p == parts.size()) parts.push_back({.box = {}, .origin = at(mesh.faces(0, f))});
    for (const int v : mesh.faces.col(f)) parts[p].box.extend(at(v));
    parts[p].area += area_vector(mesh, f).norm();
    parts[p].add(at(mesh.faces(0, f)), at(mesh.faces(1, f)), at(mesh.faces(2, f)));
  }
  for (const OpenLoop& loop : border.loops)
    for (std::size_t i = 0; i < loop.vertices.size(); ++i)
      parts[static_cast<std::size_t>(part_of_face[loop.face])].add(
          loop.middle, at(loop.vertices[i]), at(loop.vertices[(i + 1) % loop.vertices.size()]));
  return parts;
}

/// True if a part lies in an odd number of closed parts that it does not cut.
bool is_cavity(const TriMesh& mesh, const FaceTree& tree, const std::vector<int>& part_of_face,
               const std::vector<char>& counted, int part, const std::vector<int>& faces) {
  return lie_inside(mesh, tree, {faces.front(), faces[faces.size() / 2], faces.back()}, [&](int f) {
    return part_of_face[f] >= 0 && part_of_face[f] != part && counted[part_of_face[f]];
  });
}

}  // namespace

TriMesh turned_consistently(TriMesh mesh) {
  const std::vector<std::vector<Neighbour>> neighbours = neighbours_of(mesh);
  std::vector<int> turn(neighbours.size(), 0);  // 0: not reached, else ±1
  for (int first = 0; first < mesh.face_count(); ++first) {
    if (turn[first] != 0) continue;
    std::vector<int> reached = {first};
    turn[first] = 1;
    int sum = 0;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      sum += turn[reached[i]];
      for (const Neighbour& next : neighbours[reached[i]]) {
        if (turn[next.face] != 0) continue;
        turn[next.face] = next.agrees ? turn[reached[i]] : -turn[reached[i]];
        reached.push_back(next.face);
      }
    }
    const int turned = sum < 0 ? 1 : -1;
    for (const int f : reached)
      if (turn[f] == turned) turn_over(mesh, f);
  }
  return mesh;
}

TriMesh turned_outward(TriMesh mesh, Nested nested) {
  if (mesh.face_count() == 0) return mesh;
  const std::vector<int> part_of_face = part_of_faces(mesh, sorted_half_edges(mesh));
  const OpenBorder border = open_border(mesh);
  const std::vector<PartMeasures> parts = measured_parts(mesh, part_of_face, border);
  std::vector<char> closed(parts.size(), 1);
  for (const OpenLoop& loop : border.loops) closed[part_of_face[loop.face]] = 0;
  std::vector<std::vector<int>> faces(parts.size());
  for (int f = 0; f < mesh.face_count(); ++f)
    if (part_of_face[f] >= 0) faces[part_of_face[f]].push_back(f);
  const FaceTree tree(mesh);
  const std::vector<std::pair<int, int>> cutting = parts.size() > 1
                                                       ? overlapping_parts(mesh, tree, part_of_face)
                                                       : std::vector<std::pair<int, int>>();
  const PartMeasures& largest = *std::ranges::max_element(
      parts, {}, [](const PartMeasures& part) { return std::abs(part.volume); });
  for (int p = 0; p < static_cast<int>(parts.size()); ++p) {
    std::vector<char> counted = closed;
    for (const auto& [a, b] : cutting)
      if (a == p || b == p) counted[a == p ? b : a] = 0;
    const bool may_be_cavity = nested == Nested::cavity || parts[p].sense() != largest.sense();
    const bool inward = closed[p] && parts.size() > 1 && may_be_cavity &&
                        is_cavity(mesh, tree, part_of_face, counted, p, faces[p]);
    if (parts[p].sense() == (inward ? 1 : -1))
      for (const int f : faces[p]) turn_over(mesh, f);
  }
  return mesh;
}

}  // namespace hydro
