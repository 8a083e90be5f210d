#include "hydro/mesh/weld.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <vector>

#include "hydro/mesh/edge_table.h"

namespace hydro {
namespace {

using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

/// The points kept so far, hashed by their grid cells.
class KeptPoints {
 public:
  KeptPoints(const Eigen::Matrix3Xd& points, double tolerance) : points_(points) {
    const Eigen::AlignedBox3d box(points.rowwise().minCoeff(), points.rowwise().maxCoeff());
    origin_ = box.min();
    tolerance_ = tolerance;
    // A cell is much wider than the tolerance, so that a point's neighbourhood is nearly always one
    // cell, and much finer than any mesh, so that few points share a cell.
    cell_ = std::max({64 * tolerance, box.sizes().maxCoeff() * 0x1p-24, 1e-300});
    heads_.assign(std::bit_ceil(static_cast<std::size_t>(2 * points.cols())), -1);
    next_.assign(static_cast<std::size_t>(points.cols()), -1);
  }

  /// The earliest point kept within the tolerance of p, or −1.
  int find(const Eigen::Vector3d& p) const {
    const Cell low = cell_of(p.array() - tolerance_), high = cell_of(p.array() + tolerance_);
    int found = -1;
    for (auto x = low[0]; x <= high[0]; ++x)
      for (auto y = low[1]; y <= high[1]; ++y)
        for (auto z = low[2]; z <= high[2]; ++z) found = earlier(found, find_in({x, y, z}, p));
    return found;
  }

  void keep(int index) {
    int& head = heads_[slot(cell_of(points_.col(index)))];
    next_[index] = head;
    head = index;
  }

 private:
  static int earlier(int a, int b) { return a < 0 || (b >= 0 && b < a) ? b : a; }
  Cell cell_of(const Eigen::Vector3d& p) const {
    return ((p - origin_) / cell_).array().floor().cast<std::int64_t>();
  }
  /// Different cells may share a slot; find_in() compares distances.
  std::size_t slot(const Cell& c) const {
    std::uint64_t hash = 0;
    for (const std::int64_t k : c) {
      hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x9E3779B97F4A7C15u;  // 2^64 / golden ratio
      hash ^= hash >> 32;
    }
    return hash & (heads_.size() - 1);
  }
  int find_in(const Cell& cell, const Eigen::Vector3d& p) const {
    int found = -1;
    for (int i = heads_[slot(cell)]; i >= 0; i = next_[i])
      if ((points_.col(i) - p).cwiseAbs().maxCoeff() <= tolerance_) found = earlier(found, i);
    return found;
  }

  const Eigen::Matrix3Xd& points_;
  Eigen::Vector3d origin_;
  double tolerance_, cell_;
  std::vector<int> heads_;  ///< Last point kept in each slot; −1 if none.
  std::vector<int> next_;   ///< Point kept before each point in its slot.
};

/// Returns for each vertex the kept vertex that replaces it.
std::vector<int> representatives(const Eigen::Matrix3Xd& vertices, double tolerance) {
  KeptPoints kept(vertices, tolerance);
  std::vector<int> result(static_cast<std::size_t>(vertices.cols()));
  for (int i = 0; i < vertices.cols(); ++i) {
    const int found = kept.find(vertices.col(i));
    if (found < 0) kept.keep(i);
    result[i] = found < 0 ? i : found;
  }
  return result;
}

/// The mesh without the faces that name a vertex twice.
TriMesh without_collapsed_faces(TriMesh mesh) {
  Eigen::Index count = 0;
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f)
    if (!repeats_vertex(mesh, f)) mesh.faces.col(count++) = mesh.faces.col(f);
  mesh.faces.conservativeResize(3, count);
  return mesh;
}

/// The mesh without the vertices that no face names.
TriMesh without_loose_vertices(TriMesh mesh) {
  std::vector<int> place(static_cast<std::size_t>(mesh.vertex_count()), -1);
  for (const int v : mesh.faces.reshaped()) place[v] = 0;
  int count = 0;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (place[v] < 0) continue;
    mesh.vertices.col(count) = mesh.vertices.col(v);
    place[v] = count++;
  }
  mesh.vertices.conservativeResize(3, count);
  for (int& v : mesh.faces.reshaped()) v = place[v];
  return mesh;
}

}  // namespace

TriMesh welded(const TriMesh& mesh, double tolerance) {
  if (mesh.vertex_count() == 0) return mesh;
  const std::vector<int> stands_for = representatives(mesh.vertices, tolerance);
  TriMesh result = mesh;
  for (int& v : result.faces.reshaped()) v = stands_for[v];
  return without_loose_vertices(without_collapsed_faces(std::move(result)));
}

TriMesh welded_among(const TriMesh& mesh, const std::vector<int>& vertices, double tolerance) {
  if (vertices.empty()) return mesh;
  const std::vector<int> stands_for =
      representatives(Eigen::Matrix3Xd(mesh.vertices(Eigen::all, vertices)), tolerance);
  std::vector<int> merged(static_cast<std::size_t>(mesh.vertex_count()));
  std::iota(merged.begin(), merged.end(), 0);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    merged[vertices[i]] = vertices[static_cast<std::size_t>(stands_for[i])];
  TriMesh result = mesh;
  for (int& v : result.faces.reshaped()) v = merged[v];
  return without_loose_vertices(without_collapsed_faces(std::move(result)));
}

}  // namespace hydro
