#include "hydro/mesh/mending/thicken.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hydro/decompositions.h"
#include "hydro/mesh/edge_table.h"
#include "hydro/mesh/mesh_parts.h"

namespace hydro {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Eigenvalue of the normals about a vertex, over the largest, below which they agree: those of two
/// faces at 16 degrees. They then move along their mean.
constexpr double kAgreeing = 0.02;

/// Largest shift of a vertex over the thickness, where faces meet at a sharp edge.
constexpr double kLargestShift = 10;

double corner_angle(const TriMesh& mesh, Eigen::Index face, int corner) {
  const auto at = [&](int i) {
    return Vector3d(mesh.vertices.col(mesh.faces((corner + i) % 3, face)));
  };
  const Vector3d u = at(1) - at(0), v = at(2) - at(0);
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// The normals of the faces about a vertex, weighted by their angles.
struct Normals {
  Matrix3d squares = Matrix3d::Zero();
  Vector3d sum = Vector3d::Zero();

  void add(double angle, const Vector3d& normal) {
    squares += angle * normal * normal.transpose();
    sum += angle * normal;
  }
  /// Least shift that moves all planes by 1 against their normals, by least squares.
  Vector3d shift() const {
    const EigenDecomposition<3> axes = eigen_decomposition(squares);
    Vector3d shift = Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
      const double value = axes.values[i];
      if (value <= kAgreeing * axes.values[2]) continue;
      const Vector3d axis = axes.vectors.col(i);
      shift -= axis.dot(sum) / value * axis;
    }
    const double length = shift.norm();
    return length > kLargestShift ? Vector3d(shift * (kLargestShift / length)) : shift;
  }
};

/// Returns per face whether its part has an open edge.
std::vector<char> faces_of_open_parts(const TriMesh& mesh, const std::vector<HalfEdge>& edges) {
  const std::vector<int> part_of_face = part_of_faces(mesh, edges);
  std::vector<char> open(part_of_face.size(), 0), faces(part_of_face.size(), 0);
  for (std::size_t i = 0; i < edges.size();) {
    const std::size_t end = edge_end(edges, i);
    if (end - i == 1) open[part_of_face[edges[i].face]] = 1;
    i = end;
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
    faces[f] = part_of_face[f] >= 0 && open[part_of_face[f]];
  return faces;
}

}  // namespace

TriMesh thickened(const TriMesh& mesh, double thickness) {
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  const std::vector<char> open = faces_of_open_parts(mesh, edges);
  std::vector<Normals> normals(static_cast<std::size_t>(mesh.vertex_count()));
  std::vector<int> inner(normals.size(), -1);
  int count = static_cast<int>(mesh.vertex_count());
  std::vector<Eigen::Vector3i> added;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (!open[f]) continue;
    const Vector3d normal = area_vector(mesh, f).normalized();
    for (int i = 0; i < 3; ++i) {
      const int v = mesh.faces(i, f);
      normals[v].add(corner_angle(mesh, f, i), normal);
      if (inner[v] < 0) inner[v] = count++;
    }
    const auto face = mesh.faces.col(f);
    added.emplace_back(inner[face[0]], inner[face[2]], inner[face[1]]);
  }
  for (std::size_t i = 0; i < edges.size();) {
    const std::size_t end = edge_end(edges, i);
    const HalfEdge& edge = edges[i];
    const int from = edge.rising ? edge.low : edge.high, to = edge.rising ? edge.high : edge.low;
    if (end - i == 1) {
      added.emplace_back(to, from, inner[from]);
      added.emplace_back(to, inner[from], inner[to]);
    }
    i = end;
  }
  TriMesh thick = mesh;
  thick.vertices.conservativeResize(3, count);
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (inner[v] >= 0)
      thick.vertices.col(inner[v]) = mesh.vertices.col(v) + thickness * normals[v].shift();
  thick.faces.conservativeResize(3, mesh.face_count() + static_cast<Eigen::Index>(added.size()));
  for (std::size_t f = 0; f < added.size(); ++f)
    thick.faces.col(mesh.face_count() + static_cast<Eigen::Index>(f)) = added[f];
  return thick;
}

}  // namespace hydro
