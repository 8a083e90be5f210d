#include "hydro/loads/kernel/panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace hydro::kernel {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;

/// The place and direction of each face: its centroid over the size of the mesh, and half its
/// normal.
std::vector<Vector6d> features(const TriMesh& mesh) {
  const double size = mesh.vertices.colwise().norm().maxCoeff();
  std::vector<Vector6d> all(static_cast<std::size_t>(mesh.face_count()));
  for (Eigen::Index i = 0; i < mesh.face_count(); ++i) {
    const auto v = mesh.faces.col(i);
    all[i].head<3>() =
        (mesh.vertices.col(v[0]) + mesh.vertices.col(v[1]) + mesh.vertices.col(v[2])) / (3 * size);
    // Normals tell the sides of a thin plate apart; on round bodies the place decides.
    all[i].tail<3>() = 0.5 * area_vector(mesh, i).normalized();
  }
  return all;
}

/// Halves a run of faces along its widest feature until a vector is left. Leaves are ordered, too,
/// since vectors that are wholly wet or dry take less work. The first half is full.
void order(const std::vector<Vector6d>& features, int* first, int* last) {
  const auto count = last - first;
  if (count <= kMostLanes) return;
  Vector6d low = features[*first], high = low;
  for (const int* face = first; face != last; ++face) {
    low = low.cwiseMin(features[*face]);
    high = high.cwiseMax(features[*face]);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const int unit = count > kLeafFaces ? kLeafFaces : kMostLanes;
  const auto units = (count + unit - 1) / unit;
  int* middle = first + unit * ((units + 1) / 2);
  std::nth_element(first, middle, last, [&](int a, int b) {
    const double fa = features[a][axis], fb = features[b][axis];
    return fa < fb || (fa == fb && a < b);
  });
  order(features, first, middle);
  order(features, middle, last);
}

void set(double (&field)[3][kMostLanes], int at, const Eigen::Vector3d& v) {
  for (int axis = 0; axis < 3; ++axis) field[axis][at] = v[axis];
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
  FaceBlock& block = leaf.block(lane);
  const int at = lane % kMostLanes;
  set(block.c, at, c);
  set(block.n, at, n);
  set(block.e1, at, e1);
  block.area[at] = fills ? 0 : a.norm();
  for (int i = 0; i < 2; ++i) {
    block.x[i][at] = e1.dot(r[i] - c);
    block.y[i][at] = e2.dot(r[i] - c);
  }
}

/// ∫ φ_i J dS over a face.
Vector6d vertex_moment(const TriMesh& mesh, Eigen::Index face, int i) {
  const auto v = mesh.faces.col(face);
  const Eigen::Vector3d a = area_vector(mesh, face);
  Eigen::Vector3d weighted = mesh.vertices.col(v[i]);
  for (const int vertex : v) weighted += mesh.vertices.col(vertex);
  Vector6d moment;
  moment << a / 3, weighted.cross(a) / 12;
  return moment;
}

/// The blocks of the leaves, which are filled one after the other.
class VertexList {
 public:
  VertexList(const TriMesh& mesh, std::vector<VertexBlock>& blocks)
      : mesh_(mesh), blocks_(blocks), places_(static_cast<std::size_t>(mesh.vertex_count()), -1) {}

  void start_leaf() {
    first_ = static_cast<int>(blocks_.size());
    end_ = first_ * kMostLanes;
  }

  void add(Eigen::Index face, bool fills, int lane, LeafVertices& leaf) {
    for (int i = 0; i < 3; ++i) {
      const int place = place_of(mesh_.faces(i, face));
      leaf.of_face[i][lane] = place - first_ * kMostLanes;
      if (fills) continue;
      const Vector6d moment = vertex_moment(mesh_, face, i);
      for (int a = 0; a < 6; ++a) block_of(place).j[a][place % kMostLanes] += moment[a];
    }
    leaf.first = first_;
    leaf.last = static_cast<int>(blocks_.size());
  }

 private:
  VertexBlock& block_of(int place) { return blocks_[static_cast<std::size_t>(place / kMostLanes)]; }

  int place_of(int vertex) {
    int& known = places_[static_cast<std::size_t>(vertex)];
    if (known >= first_ * kMostLanes) return known;
    known = end_++;
    if (known % kMostLanes == 0) blocks_.emplace_back();
    // The rest of the block repeats it, with no moment.
    for (int lane = known % kMostLanes; lane < kMostLanes; ++lane)
      for (int axis = 0; axis < 3; ++axis)
        block_of(known).r[axis][lane] = mesh_.vertices(axis, vertex);
    return known;
  }

  const TriMesh& mesh_;
  std::vector<VertexBlock>& blocks_;
  int first_ = 0;            ///< The first block of the leaf.
  int end_ = 0;              ///< Place of its next vertex, counted through all blocks.
  std::vector<int> places_;  ///< The place where each vertex was met last; -1: none.
};

}  // namespace

Face face_of(const Leaf& leaf, int lane) {
  const FaceBlock& block = leaf.block(lane);
  const int at = lane % kMostLanes;
  const auto vector = [&](const double(&field)[3][kMostLanes]) {
    return Eigen::Vector3d(field[0][at], field[1][at], field[2][at]);
  };
  Face face{vector(block.c), vector(block.n), vector(block.e1), {}, block.area[at], {}, {}};
  face.e2 = face.n.cross(face.e1);
  face.x << block.x[0][at], block.x[1][at], -(block.x[0][at] + block.x[1][at]);
  face.y << block.y[0][at], block.y[1][at], -(block.y[0][at] + block.y[1][at]);
  return face;
}

Panels make_panels(const TriMesh& mesh_B) {
  Panels panels;
  for (int i = 0; i < static_cast<int>(mesh_B.face_count()); ++i)
    if (area_vector(mesh_B, i).norm() > 0) panels.face.push_back(i);
  if (panels.face.empty()) return panels;
  order(features(mesh_B), panels.face.data(), panels.face.data() + panels.face.size());
  const std::size_t leaves = (panels.face.size() + kLeafFaces - 1) / kLeafFaces;
  panels.leaves.resize(leaves);
  panels.vertices.resize(leaves);
  VertexList vertices(mesh_B, panels.blocks);
  for (std::size_t leaf = 0; leaf < leaves; ++leaf) {
    vertices.start_leaf();
    for (int lane = 0; lane < kLeafFaces; ++lane) {
      const std::size_t place = leaf * kLeafFaces + static_cast<std::size_t>(lane);
      const bool fills = place >= panels.face.size();
      const int face = fills ? panels.face.back() : panels.face[place];
      lay_out(mesh_B, face, fills, lane, panels.leaves[leaf]);
      vertices.add(face, fills, lane, panels.vertices[leaf]);
    }
  }
  panels.longest_edge = longest_edge(mesh_B);
  return panels;
}

}  // namespace hydro::kernel
