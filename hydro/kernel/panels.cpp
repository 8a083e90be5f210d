#include "hydro/kernel/panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace hydro::kernel {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;

/// Where a face is and where it looks: centroids over half the size of the mesh, and normals.
std::vector<Vector6d> features(const TriMesh& mesh) {
  const double size = mesh.vertices.colwise().norm().maxCoeff();
  std::vector<Vector6d> all(static_cast<std::size_t>(mesh.face_count()));
  for (Eigen::Index i = 0; i < mesh.face_count(); ++i) {
    const auto v = mesh.faces.col(i);
    all[i].head<3>() =
        (mesh.vertices.col(v[0]) + mesh.vertices.col(v[1]) + mesh.vertices.col(v[2])) / (3 * size);
    // Sides of a thin plate are told apart by their normals; on round bodies place decides.
    all[i].tail<3>() = 0.5 * area_vector(mesh, i).normalized();
  }
  return all;
}

/// Halves a run of faces along its widest feature until a leaf is left. The first part is full.
void order(const std::vector<Vector6d>& features, int* first, int* last) {
  const auto count = last - first;
  if (count <= kLeafFaces) return;
  Vector6d low = features[*first], high = low;
  for (const int* face = first; face != last; ++face) {
    low = low.cwiseMin(features[*face]);
    high = high.cwiseMax(features[*face]);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const auto leaves = (count + kLeafFaces - 1) / kLeafFaces;
  int* middle = first + kLeafFaces * ((leaves + 1) / 2);
  std::nth_element(first, middle, last, [&](int a, int b) {
    const double fa = features[a][axis], fb = features[b][axis];
    return fa < fb || (fa == fb && a < b);
  });
  order(features, first, middle);
  order(features, middle, last);
}

void set(double (&field)[3][kLeafFaces], int lane, const Eigen::Vector3d& v) {
  for (int axis = 0; axis < 3; ++axis) field[axis][lane] = v[axis];
}

/// Puts a face into a lane; `area` is 0 for one that only fills the leaf.
void lay_out(const TriMesh& mesh, Eigen::Index face, bool fills, int lane, Leaf& leaf) {
  const auto v = mesh.faces.col(face);
  const Eigen::Vector3d r[3] = {mesh.vertices.col(v[0]), mesh.vertices.col(v[1]),
                                mesh.vertices.col(v[2])};
  const Eigen::Vector3d c = (r[0] + r[1] + r[2]) / 3;
  const Eigen::Vector3d a = area_vector(mesh, face);
  const Eigen::Vector3d n = a.normalized();
  // The longest side has the best direction; a sliver's shortest has none.
  int side = 0;
  for (int i = 1; i < 3; ++i)
    if ((r[(i + 1) % 3] - r[i]).norm() > (r[(side + 1) % 3] - r[side]).norm()) side = i;
  const Eigen::Vector3d along = r[(side + 1) % 3] - r[side];
  const Eigen::Vector3d e1 = (along - along.dot(n) * n).normalized();
  const Eigen::Vector3d e2 = n.cross(e1);
  set(leaf.c, lane, c);
  set(leaf.n, lane, n);
  set(leaf.e1, lane, e1);
  leaf.area[lane] = fills ? 0 : a.norm();
  for (int i = 0; i < 2; ++i) {
    leaf.x[i][lane] = e1.dot(r[i] - c);
    leaf.y[i][lane] = e2.dot(r[i] - c);
  }
}

void list_vertices(const TriMesh& mesh, Eigen::Index face, int lane, std::map<int, int>& known,
                   LeafVertices& leaf) {
  for (int i = 0; i < 3; ++i) {
    const int vertex = mesh.faces(i, face);
    const auto [place, added] = known.try_emplace(vertex, leaf.count);
    if (added) {
      for (int axis = 0; axis < 3; ++axis) leaf.r[axis][leaf.count] = mesh.vertices(axis, vertex);
      ++leaf.count;
    }
    leaf.of_face[i][lane] = place->second;
  }
}

/// Repeats the last vertex up to the end of a vector of eight.
void fill_up(LeafVertices& leaf) {
  for (int i = leaf.count; i % 8 != 0; ++i)
    for (auto& axis : leaf.r) axis[i] = axis[leaf.count - 1];
}

}  // namespace

Panels make_panels(const TriMesh& mesh_B) {
  Panels panels;
  for (int i = 0; i < static_cast<int>(mesh_B.face_count()); ++i)
    if (area_vector(mesh_B, i).norm() > 0) panels.face.push_back(i);
  if (panels.face.empty()) return panels;
  order(features(mesh_B), panels.face.data(), panels.face.data() + panels.face.size());
  const std::size_t leaves = (panels.face.size() + kLeafFaces - 1) / kLeafFaces;
  panels.leaves.resize(leaves);
  panels.vertices.resize(leaves);
  std::map<int, int> known;
  for (std::size_t place = 0; place < leaves * kLeafFaces; ++place) {
    const std::size_t leaf = place / kLeafFaces;
    const int lane = static_cast<int>(place % kLeafFaces);
    if (lane == 0) known.clear();
    const bool fills = place >= panels.face.size();
    const int face = fills ? panels.face.back() : panels.face[place];
    lay_out(mesh_B, face, fills, lane, panels.leaves[leaf]);
    list_vertices(mesh_B, face, lane, known, panels.vertices[leaf]);
    for (int i = 0; i < 3; ++i) {
      const auto side = mesh_B.vertices.col(mesh_B.faces(i, face)) -
                        mesh_B.vertices.col(mesh_B.faces((i + 1) % 3, face));
      panels.longest_edge = std::max(panels.longest_edge, side.norm());
    }
  }
  for (LeafVertices& leaf : panels.vertices) fill_up(leaf);
  return panels;
}

}  // namespace hydro::kernel
