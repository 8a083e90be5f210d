#include "hydro/mesh/mesh_parts.h"

#include "hydro/mesh/face_sheets.h"

namespace hydro {
namespace {

struct PartTable {
  std::vector<MeshPart> parts;
  std::vector<int> part_of_face;             ///< −1 for a face that names a vertex twice.
  std::vector<std::vector<int>> some_faces;  ///< First, middle and last face of each part.
};

/// Six times the volume of the tetrahedron between a face and a point [m^3].
double spanned(const TriMesh& mesh, int face, const Eigen::Vector3d& p) {
  const Eigen::Vector3d a = mesh.vertices.col(mesh.faces(0, face)) - p;
  const Eigen::Vector3d b = mesh.vertices.col(mesh.faces(1, face)) - p;
  const Eigen::Vector3d c = mesh.vertices.col(mesh.faces(2, face)) - p;
  return a.dot(b.cross(c));
}

PartTable part_table(const TriMesh& mesh, const std::vector<HalfEdge>& edges) {
  PartTable table{.parts = {}, .part_of_face = part_of_faces(mesh, edges), .some_faces = {}};
  std::vector<int> faces_in;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int label = table.part_of_face[f];
    if (label < 0) continue;
    if (label == static_cast<int>(table.parts.size())) {
      table.parts.push_back({.first_face = f});
      faces_in.push_back(0);
    }
    ++faces_in[label];
    MeshPart& part = table.parts[label];
    part.volume += spanned(mesh, f, mesh.vertices.col(mesh.faces(0, part.first_face))) / 6;
  }
  table.some_faces.resize(table.parts.size());
  std::vector<int> seen(table.parts.size(), 0);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int label = table.part_of_face[f];
    if (label < 0) continue;
    const int i = seen[label]++;
    if (i == 0 || i == faces_in[label] / 2 || i == faces_in[label] - 1)
      table.some_faces[label].push_back(f);
  }
  return table;
}

}  // namespace

std::vector<int> part_of_faces(const TriMesh& mesh, const std::vector<HalfEdge>& edges) {
  FaceSheets sets(mesh.face_count());
  for (std::size_t i = 0; i < edges.size(); i = edge_end(edges, i))
    for (std::size_t j = i + 1, end = edge_end(edges, i); j < end; ++j)
      sets.join(edges[i].face, edges[j].face);
  std::vector<int> labels;
  int parts = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int first = repeats_vertex(mesh, f) ? -1 : sets.of(f);
    labels.push_back(first < 0 ? -1 : first == f ? parts++ : labels[first]);
  }
  return labels;
}

bool lie_inside(const TriMesh& mesh, const FaceTree& tree, const std::vector<int>& faces,
                const std::function<bool(int)>& counts) {
  // The direction is no axis, diagonal or other likely direction of an edge.
  const Eigen::Vector3d direction(0.5403023058681398, 0.2983386154170817, 0.7867955282450121);
  int inside = 0;
  for (const int face : faces) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int v : mesh.faces.col(face)) middle += mesh.vertices.col(v) / 3;
    inside += tree.crossings(middle, direction, counts) % 2 == 1 ? 1 : -1;
  }
  return inside > 0;
}

std::vector<MeshPart> closed_parts(const TriMesh& mesh, const std::vector<HalfEdge>& edges,
                                   const FaceTree& tree) {
  PartTable table = part_table(mesh, edges);
  if (table.parts.size() == 1) return table.parts;
  for (std::size_t i = 0; i < table.parts.size(); ++i)
    table.parts[i].in_other = lie_inside(mesh, tree, table.some_faces[i], [&](int f) {
      return table.part_of_face[f] >= 0 && table.part_of_face[f] != static_cast<int>(i);
    });
  return table.parts;
}

}  // namespace hydro
