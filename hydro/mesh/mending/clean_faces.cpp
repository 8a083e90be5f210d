#include "hydro/mesh/mending/clean_faces.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "hydro/mesh/edge_table.h"
#include "hydro/mesh/face_sheets.h"
#include "hydro/mesh/face_tree.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/open_loops.h"
#include "hydro/mesh/side_splitter.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// Least distance of a T-junction from the ends of a side, over the tolerance. Nearer vertices are
/// those of wider cracks, and to split sides there makes slivers without end.
constexpr double kFromEnds = 10;

template <class Kept>
TriMesh with_faces(const TriMesh& mesh, Kept kept) {
  TriMesh result{mesh.vertices, Eigen::Matrix3Xi(3, mesh.face_count())};
  Eigen::Index count = 0;
  for (int f = 0; f < mesh.face_count(); ++f)
    if (kept(f)) result.faces.col(count++) = mesh.faces.col(f);
  result.faces.conservativeResize(3, count);
  return result;
}

std::array<int, 3> sorted_corners(const TriMesh& mesh, int face) {
  std::array<int, 3> corners = {mesh.faces(0, face), mesh.faces(1, face), mesh.faces(2, face)};
  std::ranges::sort(corners);
  return corners;
}

/// True if the order of a face's vertices is an even permutation of the ascending one.
bool is_even(const TriMesh& mesh, int face) {
  const auto f = mesh.faces.col(face);
  return (f[0] < f[1]) + (f[1] < f[2]) + (f[2] < f[0]) == 2;
}

/// Returns per face the number of the first face with its vertices; the face's own if it is first.
std::vector<int> first_copies(const TriMesh& mesh) {
  std::map<std::array<int, 3>, int> known;
  std::vector<int> first;
  for (int f = 0; f < mesh.face_count(); ++f)
    first.push_back(known.emplace(sorted_corners(mesh, f), f).first->second);
  return first;
}

/// Returns per face whether it belongs to a sheet of doubled faces that parts a solid: all edges on
/// which the sheet meets other faces have two of those.
std::vector<char> parting_sheets(const TriMesh& mesh, const std::vector<char>& doubled) {
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  FaceSheets sheets(mesh.face_count());
  for (std::size_t i = 0; i < edges.size(); i = edge_end(edges, i))
    for (std::size_t j = i, first = edges.size(); j < edge_end(edges, i); ++j) {
      if (!doubled[edges[j].face]) continue;
      if (first < edges.size()) sheets.join(edges[first].face, edges[j].face);
      first = std::min(first, j);
    }
  std::vector<char> bordered(doubled.size(), 0), wrong(doubled.size(), 0);
  for (std::size_t i = 0; i < edges.size(); i = edge_end(edges, i)) {
    int others = 0, one = -1;
    for (std::size_t j = i; j < edge_end(edges, i); ++j)
      doubled[edges[j].face] ? void(one = edges[j].face) : void(++others);
    if (one < 0) continue;
    if (others == 2) bordered[sheets.of(one)] = 1;
    if (others == 1 || others > 2) wrong[sheets.of(one)] = 1;
  }
  std::vector<char> parting(doubled.size(), 0);
  for (int f = 0; f < mesh.face_count(); ++f)
    parting[f] = doubled[f] && bordered[sheets.of(f)] && !wrong[sheets.of(f)];
  return parting;
}

/// True if a ray from a point leaves the mesh in one of 26 directions.
bool sees_outside(const FaceTree& tree, const Vector3d& p) {
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        // A little off the axes and diagonals, along which edges lie.
        const Vector3d direction(x + 0.0137, y - 0.0213, z + 0.0089);
        if ((x || y || z) && tree.crossings(p, direction, [](int) { return true; }) == 0)
          return true;
      }
  return false;
}

/// True if one of some faces of a sheet, from its beginning to its end, is seen from outside.
bool is_seen(const TriMesh& mesh, const FaceTree& tree, const std::vector<int>& sheet) {
  constexpr std::size_t kMostFaces = 64;
  const double off = 1e-6 * bounding_box(mesh).diagonal().norm();
  const std::size_t stride = std::max<std::size_t>(1, sheet.size() / kMostFaces);
  for (std::size_t i = 0; i < sheet.size(); i += stride) {
    const Vector3d middle = mesh.vertices(Eigen::all, mesh.faces.col(sheet[i])).rowwise().mean();
    const Vector3d normal = area_vector(mesh, sheet[i]).normalized();
    if (sees_outside(tree, middle + off * normal) || sees_outside(tree, middle - off * normal))
      return true;
  }
  return false;
}

/// Returns per face whether its sheet ends at crowded edges only, and so may be a wall inside.
std::vector<char> walled_faces(const std::vector<HalfEdge>& edges, FaceSheets& sheets,
                               Eigen::Index faces) {
  std::vector<char> open(static_cast<std::size_t>(faces), 0), crowded = open, walled = open;
  for (std::size_t i = 0; i < edges.size();) {
    const std::size_t end = edge_end(edges, i);
    for (std::size_t j = i; j < end; ++j) {
      if (end - i == 1) open[sheets.of(edges[j].face)] = 1;
      if (end - i > 2) crowded[sheets.of(edges[j].face)] = 1;
    }
    i = end;
  }
  for (int f = 0; f < faces; ++f) walled[f] = crowded[sheets.of(f)] && !open[sheets.of(f)];
  return walled;
}

/// Returns per face whether it has an open edge.
std::vector<char> faces_at_border(const TriMesh& mesh) {
  std::vector<char> open(static_cast<std::size_t>(mesh.face_count()), 0);
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  for (std::size_t i = 0; i < edges.size();) {
    const std::size_t end = edge_end(edges, i);
    if (end - i == 1) open[edges[i].face] = 1;
    i = end;
  }
  return open;
}

std::ptrdiff_t count_open_edges(const TriMesh& mesh) {
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  std::ptrdiff_t count = 0;
  for (std::size_t i = 0; i < edges.size();) {
    const std::size_t end = edge_end(edges, i);
    count += end - i == 1;
    i = end;
  }
  return count;
}

}  // namespace

TriMesh without_flat_faces(const TriMesh& mesh) {
  return with_faces(mesh, [&](int f) { return !has_no_area(mesh, f); });
}

TriMesh without_duplicate_faces(const TriMesh& mesh) {
  const std::vector<int> first = first_copies(mesh);
  std::vector<char> doubled(first.size(), 0);
  for (int f = 0; f < mesh.face_count(); ++f)
    if (first[f] != f && is_even(mesh, f) != is_even(mesh, first[f]))
      doubled[f] = doubled[first[f]] = 1;
  const std::vector<char> parting = parting_sheets(mesh, doubled);
  return with_faces(mesh, [&](int f) { return first[f] == f && !parting[f]; });
}

TriMesh without_inner_walls(const TriMesh& mesh) {
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  FaceSheets sheets = sheets_of(edges, mesh.face_count());
  const std::vector<char> walled = walled_faces(edges, sheets, mesh.face_count());
  if (std::ranges::count(walled, 1) == 0) return mesh;
  std::vector<std::vector<int>> faces(walled.size());
  for (int f = 0; f < mesh.face_count(); ++f)
    if (walled[f] && !has_no_area(mesh, f)) faces[sheets.of(f)].push_back(f);
  const FaceTree tree(mesh);
  std::vector<char> seen(walled.size(), 0);
  for (std::size_t sheet = 0; sheet < faces.size(); ++sheet)
    seen[sheet] = is_seen(mesh, tree, faces[sheet]);
  return with_faces(mesh, [&](int f) { return !walled[f] || seen[sheets.of(f)]; });
}

TriMesh stitched(const TriMesh& mesh, double tolerance) {
  std::vector<int> vertices = open_vertices(mesh);
  if (vertices.empty()) return mesh;
  TriMesh split = split_sides(mesh, std::move(vertices), tolerance, kFromEnds * tolerance,
                              faces_at_border(mesh));
  return count_open_edges(split) < count_open_edges(mesh) ? split : mesh;
}

Eigen::Index count_t_junctions(const TriMesh& mesh, double tolerance) {
  return stitched(mesh, tolerance).face_count() - mesh.face_count();
}

}  // namespace hydro
