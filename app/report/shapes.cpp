#include "app/report/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace app {
namespace {

/// Smallest number of faces to which a shape is coarsened, so that it can be recognised.
constexpr Eigen::Index kLeastFaces = 64;

/// Factor by which cells are widened until few enough faces remain [-].
constexpr double kWiden = 1.25;

double area(const hydro::TriMesh& mesh) {
  double sum = 0;
  for (Eigen::Index i = 0; i < mesh.face_count(); ++i) sum += hydro::area_vector(mesh, i).norm();
  return sum;
}

/// Returns the mesh with the vertices in each cell of a grid merged.
hydro::TriMesh clustered(const hydro::TriMesh& mesh, double cell) {
  std::map<std::array<double, 3>, int> cells;
  std::vector<int> cluster;
  std::vector<Eigen::Vector4d> sums;  // sums of the vertices, and their number
  for (const auto& v : mesh.vertices.colwise()) {
    const std::array<double, 3> key = {std::floor(v.x() / cell), std::floor(v.y() / cell),
                                       std::floor(v.z() / cell)};
    const auto [entry, is_new] = cells.try_emplace(key, static_cast<int>(sums.size()));
    if (is_new) sums.emplace_back(Eigen::Vector4d::Zero());
    sums[static_cast<std::size_t>(entry->second)] += Eigen::Vector4d(v.x(), v.y(), v.z(), 1);
    cluster.push_back(entry->second);
  }
  hydro::TriMesh coarse;
  coarse.vertices.resize(3, static_cast<Eigen::Index>(sums.size()));
  for (std::size_t i = 0; i < sums.size(); ++i)
    coarse.vertices.col(static_cast<Eigen::Index>(i)) = sums[i].head<3>() / sums[i].w();
  coarse.faces.resize(3, mesh.face_count());
  Eigen::Index count = 0;
  for (const auto& face : mesh.faces.colwise()) {
    const Eigen::Vector3i f(cluster[static_cast<std::size_t>(face[0])],
                            cluster[static_cast<std::size_t>(face[1])],
                            cluster[static_cast<std::size_t>(face[2])]);
    if (f[0] != f[1] && f[1] != f[2] && f[2] != f[0]) coarse.faces.col(count++) = f;
  }
  coarse.faces.conservativeResize(3, count);
  return coarse;
}

}  // namespace

hydro::TriMesh coarsened(const hydro::TriMesh& mesh, Eigen::Index most_faces) {
  if (mesh.face_count() <= most_faces) return mesh;
  // The estimate is two triangles per square of the grid.
  double cell = std::sqrt(2 * area(mesh) / static_cast<double>(most_faces));
  hydro::TriMesh coarse = clustered(mesh, cell);
  while (coarse.face_count() > most_faces) coarse = clustered(mesh, cell *= kWiden);
  return coarse;
}

hydro::HeightField coarsened(const hydro::HeightField& field, Eigen::Index most) {
  const Eigen::Index rows = field.heights.rows(), columns = field.heights.cols();
  // The last row or column may lie beyond the edge, where the height of the edge holds.
  const auto count = [](Eigen::Index all, Eigen::Index stride) {
    return (all - 1 + stride - 1) / stride + 1;
  };
  Eigen::Index stride = 1;
  while (count(rows, stride) * count(columns, stride) > most) ++stride;
  if (stride == 1) return field;
  hydro::HeightField coarse = field;
  coarse.cell *= static_cast<double>(stride);
  coarse.heights.resize(count(rows, stride), count(columns, stride));
  for (Eigen::Index i = 0; i < coarse.heights.rows(); ++i)
    for (Eigen::Index j = 0; j < coarse.heights.cols(); ++j)
      coarse.heights(i, j) =
          field.heights(std::min(i * stride, rows - 1), std::min(j * stride, columns - 1));
  return coarse;
}

Shapes find_shapes(const std::vector<engine::BodySpec>& bodies, Eigen::Index most_faces) {
  Shapes found;
  std::vector<const hydro::TriMesh*> meshes;
  Eigen::Index faces = 0;
  for (const engine::BodySpec& body : bodies) {
    const auto same = std::find_if(meshes.begin(), meshes.end(), [&](const hydro::TriMesh* mesh) {
      return hydro::same_mesh(*mesh, body.mesh_B);
    });
    found.of_body.push_back(static_cast<std::size_t>(same - meshes.begin()));
    if (same != meshes.end()) continue;
    meshes.push_back(&body.mesh_B);
    faces += body.mesh_B.face_count();
  }
  const double share = std::min(
      1.0, static_cast<double>(most_faces) / static_cast<double>(std::max<Eigen::Index>(faces, 1)));
  for (const hydro::TriMesh* mesh : meshes) {
    const double own = share * static_cast<double>(mesh->face_count());
    found.shapes.push_back({coarsened(*mesh, std::max(kLeastFaces, static_cast<Eigen::Index>(own))),
                            mesh->face_count()});
  }
  return found;
}

}  // namespace app
