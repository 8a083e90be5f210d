#include "hydro/mesh/mending/mirror.h"

#include <cmath>
#include <vector>

namespace hydro {

std::optional<TriMesh> with_mirror_image(TriMesh mesh, int axis, double tolerance) {
  for (double& at : mesh.vertices.row(axis))
    if (std::abs(at) <= tolerance) at = 0;
  if (mesh.vertex_count() == 0 ||
      (mesh.vertices.row(axis).minCoeff() < 0 && mesh.vertices.row(axis).maxCoeff() > 0))
    return std::nullopt;
  const auto on_plane = [&](int v) { return mesh.vertices(axis, v) == 0; };
  const Eigen::Index count = mesh.vertex_count();
  std::vector<int> image;
  Eigen::Index added = 0;
  for (int v = 0; v < count; ++v)
    image.push_back(on_plane(v) ? v : static_cast<int>(count + added++));
  TriMesh whole{Eigen::Matrix3Xd(3, count + added), Eigen::Matrix3Xi(3, 2 * mesh.face_count())};
  whole.vertices.leftCols(count) = mesh.vertices;
  for (int v = 0; v < count; ++v) {
    if (on_plane(v)) continue;
    whole.vertices.col(image[v]) = mesh.vertices.col(v);
    whole.vertices(axis, image[v]) *= -1;
  }
  Eigen::Index faces = 0;
  for (const auto& f : mesh.faces.colwise()) {
    if (on_plane(f[0]) && on_plane(f[1]) && on_plane(f[2])) continue;
    whole.faces.col(faces++) = f;
    whole.faces.col(faces++) << image[f[0]], image[f[2]], image[f[1]];
  }
  whole.faces.conservativeResize(3, faces);
  return whole;
}

}  // namespace hydro
