#include "hydro/mesh/mesh.h"

#include <algorithm>

namespace hydro {

bool same_mesh(const TriMesh& a, const TriMesh& b) {
  return a.vertex_count() == b.vertex_count() && a.face_count() == b.face_count() &&
         a.vertices == b.vertices && a.faces == b.faces;
}

TriMesh translated(TriMesh mesh, const Eigen::Vector3d& offset) {
  mesh.vertices.colwise() += offset;
  return mesh;
}

TriMesh scaled(TriMesh mesh, double factor) {
  mesh.vertices *= factor;
  return factor < 0 ? flipped(std::move(mesh)) : mesh;
}

TriMesh transformed(TriMesh mesh_B, const Eigen::Isometry3d& X_AB) {
  mesh_B.vertices = (X_AB.linear() * mesh_B.vertices).colwise() + X_AB.translation();
  return mesh_B;
}

TriMesh flipped(TriMesh mesh) {
  mesh.faces.row(1).swap(mesh.faces.row(2));
  return mesh;
}

Eigen::Vector3d area_vector(const TriMesh& mesh, Eigen::Index face) {
  const Eigen::Vector3d a = mesh.vertices.col(mesh.faces(0, face));
  const Eigen::Vector3d b = mesh.vertices.col(mesh.faces(1, face));
  const Eigen::Vector3d c = mesh.vertices.col(mesh.faces(2, face));
  return 0.5 * (b - a).cross(c - a);
}

double longest_edge(const TriMesh& mesh) {
  double longest = 0;
  for (const auto f : mesh.faces.colwise())
    for (int i = 0; i < 3; ++i)
      longest =
          std::max(longest, (mesh.vertices.col(f[i]) - mesh.vertices.col(f[(i + 1) % 3])).norm());
  return longest;
}

Eigen::AlignedBox3d bounding_box(const TriMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (Eigen::Index i = 0; i < mesh.vertex_count(); ++i) box.extend(mesh.vertices.col(i));
  return box;
}

}  // namespace hydro
