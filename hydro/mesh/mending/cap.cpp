#include "hydro/mesh/mending/cap.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hydro/mesh/mesh_parts.h"
#include "hydro/mesh/open_loops.h"
#include "hydro/mesh/region_cut.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// Sine of the angle up to which planes are parallel, and the distance up to which they are one,
/// relative to the extent of the loops in them.
constexpr double kSamePlane = 2e-3;

bool in_one_plane(const OpenLoop& a, const OpenLoop& b) {
  const double extent = std::max(a.extent, b.extent);
  return a.normal.cross(b.normal).norm() <= kSamePlane &&
         std::abs(a.normal.dot(b.middle - a.middle)) <= kSamePlane * extent;
}

/// A loop to be filled, with the loop around it.
struct Rim {
  const OpenLoop* loop;
  int around = -1;    ///< The smallest rim around it; −1 if none.
  bool hole = false;  ///< True if it is a hole in the cap of the rim around it.
};

bool lies_inside(const std::vector<Vector3d>& vertices, const OpenLoop& inner,
                 const OpenLoop& outer) {
  const auto inside = std::ranges::count_if(inner.vertices, [&](int v) {
    return encloses(vertices, outer.vertices, outer.normal, vertices[static_cast<std::size_t>(v)]);
  });
  return 2 * inside > static_cast<std::ptrdiff_t>(inner.vertices.size());
}

/// Finds the holes, from the largest loop on: of those around a loop the smallest is the last.
void nest(const std::vector<Vector3d>& vertices, std::vector<Rim>& rims) {
  std::ranges::stable_sort(rims, std::ranges::greater(),
                           [](const Rim& rim) { return rim.loop->area; });
  for (std::size_t i = 0; i < rims.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k)
      if (in_one_plane(*rims[k].loop, *rims[i].loop) &&
          lies_inside(vertices, *rims[i].loop, *rims[k].loop))
        rims[i].around = static_cast<int>(k);
    if (rims[i].around < 0) continue;
    const Rim& around = rims[static_cast<std::size_t>(rims[i].around)];
    rims[i].hole = !around.hole && around.loop->normal.dot(rims[i].loop->normal) < 0;
  }
}

/// Returns per part whether it lies in the plane of one of its loops.
std::vector<char> flat_parts(const TriMesh& mesh, const std::vector<int>& part_of_face,
                             const std::vector<OpenLoop>& loops) {
  std::vector<const OpenLoop*> loop_of_part;
  for (const OpenLoop& loop : loops) {
    const auto part = static_cast<std::size_t>(part_of_face[loop.face]);
    loop_of_part.resize(std::max(loop_of_part.size(), part + 1), nullptr);
    if (loop.shape == LoopShape::flat) loop_of_part[part] = &loop;
  }
  std::vector<char> flat(loop_of_part.size(), 1);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int part = part_of_face[f];
    if (part < 0 || part >= static_cast<int>(flat.size()) || !loop_of_part[part]) continue;
    const OpenLoop& loop = *loop_of_part[part];
    for (const int v : mesh.faces.col(f))
      if (std::abs(loop.normal.dot(mesh.vertices.col(v) - loop.middle)) > kSamePlane * loop.extent)
        flat[part] = 0;
  }
  return flat;
}

}  // namespace

CappedMesh capped(const TriMesh& mesh) {
  const OpenBorder border = open_border(mesh);
  const std::vector<int> part_of_face = part_of_faces(mesh, sorted_half_edges(mesh));
  const std::vector<char> flat = flat_parts(mesh, part_of_face, border.loops);
  std::vector<Rim> rims;
  for (const OpenLoop& loop : border.loops)
    if (loop.shape == LoopShape::flat && !flat[part_of_face[loop.face]]) rims.push_back({&loop});
  std::vector<Vector3d> vertices;
  for (const auto& v : mesh.vertices.colwise()) vertices.emplace_back(v);
  nest(vertices, rims);
  std::vector<Eigen::Vector3i> faces;
  for (std::size_t i = 0; i < rims.size(); ++i) {
    if (rims[i].hole) continue;
    std::vector<std::vector<int>> holes;
    for (const Rim& rim : rims)
      if (rim.hole && rim.around == static_cast<int>(i)) holes.push_back(rim.loop->vertices);
    cut_region(vertices, rims[i].loop->vertices, std::move(holes), rims[i].loop->normal, faces);
  }
  CappedMesh result{mesh, static_cast<int>(rims.size())};
  const Eigen::Index before = mesh.face_count();
  result.mesh.faces.conservativeResize(3, before + static_cast<Eigen::Index>(faces.size()));
  for (std::size_t f = 0; f < faces.size(); ++f)
    result.mesh.faces.col(before + static_cast<Eigen::Index>(f)) = faces[f];
  return result;
}

}  // namespace hydro
