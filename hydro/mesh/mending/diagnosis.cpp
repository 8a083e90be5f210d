#include "hydro/mesh/mending/diagnosis.h"

#include <algorithm>
#include <cmath>

#include "hydro/mesh/edge_table.h"
#include "hydro/mesh/face_tree.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mending/clean_faces.h"
#include "hydro/mesh/mending/solid_union.h"
#include "hydro/mesh/mending/turn_faces.h"
#include "hydro/mesh/mesh_overlap.h"
#include "hydro/mesh/mesh_parts.h"

namespace hydro {
namespace {

/// Most pairs of parts whose common volume is computed.
constexpr std::size_t kMostOverlaps = 10;

/// Cracks that are tried, over the default.
constexpr double kWiderCracks[] = {1, 10, 100};

TriMesh part_mesh(const TriMesh& mesh, const std::vector<int>& part_of_face, int part) {
  TriMesh one{mesh.vertices, Eigen::Matrix3Xi(3, mesh.face_count())};
  Eigen::Index count = 0;
  for (int f = 0; f < mesh.face_count(); ++f)
    if (part_of_face[f] == part) one.faces.col(count++) = mesh.faces.col(f);
  one.faces.conservativeResize(3, count);
  return one;
}

/// Returns the volume that two closed parts share.
std::optional<double> common_volume(TriMesh a, TriMesh b) {
  a = turned_outward(std::move(a));
  b = turned_outward(std::move(b));
  const std::optional<TriMesh> both = united({a, b});
  if (!both) return std::nullopt;
  return solid_properties(a).volume + solid_properties(b).volume - solid_properties(*both).volume;
}

void add_overlaps(const TriMesh& mesh, const std::vector<int>& part_of_face,
                  MeshDiagnosis& diagnosis) {
  const FaceTree tree(mesh);
  for (const auto& [a, b] : overlapping_parts(mesh, tree, part_of_face)) {
    DiagnosedOverlap overlap{.first = a, .second = b, .volume = std::nullopt};
    if (!diagnosis.parts[a].closed || !diagnosis.parts[b].closed) continue;
    if (diagnosis.overlaps.size() < kMostOverlaps)
      overlap.volume =
          common_volume(part_mesh(mesh, part_of_face, a), part_mesh(mesh, part_of_face, b));
    diagnosis.overlaps.push_back(overlap);
  }
}

/// True if the mesh lies on one side of the plane normal to an axis and has no face in it, and a
/// tenth of an open loop or more runs there.
bool ends_at_plane(const TriMesh& mesh, int axis) {
  constexpr double kLeastShare = 0.1;
  const double margin = default_weld(mesh);
  const auto along = mesh.vertices.row(axis);
  if (along.minCoeff() < -margin && along.maxCoeff() > margin) return false;
  for (const auto& f : mesh.faces.colwise())
    if (along(Eigen::all, f).cwiseAbs().maxCoeff() <= margin) return false;
  const auto runs_in_plane = [&](const OpenLoop& loop) {
    double length = 0;
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
      const int v = loop.vertices[i], w = loop.vertices[(i + 1) % loop.vertices.size()];
      if (std::max(std::abs(along[v]), std::abs(along[w])) <= margin)
        length += (mesh.vertices.col(v) - mesh.vertices.col(w)).norm();
    }
    return length >= kLeastShare * loop.length;
  };
  return std::ranges::any_of(open_border(mesh).loops, runs_in_plane);
}

/// Rounds a width up to one digit, so that it can be told in one.
double rounded_up(double width) {
  const double unit = std::pow(10, std::floor(std::log10(width)));
  return std::ceil(width / unit - 1e-9) * unit;
}

/// Returns the options to be tried, in this order.
std::vector<MendOptions> candidates(const TriMesh& mesh) {
  std::vector<double> cracks;
  for (const double factor : kWiderCracks)
    cracks.push_back(rounded_up(factor * default_weld(mesh)));
  std::vector<MendOptions> all;
  for (const double crack : cracks) all.push_back({.weld = crack, .mirror = {}, .thickness = {}});
  const TriMesh agreeing = turned_consistently(mesh);
  for (const int axis : {1, 0})
    if (ends_at_plane(agreeing, axis))
      for (const bool cap : {false, true})
        all.push_back({.weld = cracks[0], .cap = cap, .mirror = axis, .thickness = {}});
  for (const double crack : cracks)
    all.push_back({.weld = crack, .cap = true, .mirror = {}, .thickness = {}});
  for (const bool cap : {false, true})
    all.push_back({.weld = cracks[0], .cap = cap, .mirror = {}, .unite = true, .thickness = {}});
  return all;
}

}  // namespace

MeshDiagnosis diagnosed(const TriMesh& mesh) {
  MeshDiagnosis diagnosis{.report = check_mesh(mesh)};
  const TriMesh agreeing = turned_consistently(mesh);
  const std::vector<HalfEdge> edges = sorted_half_edges(agreeing);
  const std::vector<int> part_of_face = part_of_faces(agreeing, edges);
  std::vector<DiagnosedPart>& parts = diagnosis.parts;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (part_of_face[f] < 0) continue;
    const auto p = static_cast<std::size_t>(part_of_face[f]);
    if (p == parts.size()) parts.push_back({.box = {}, .closed = true});
    ++parts[p].faces;
    parts[p].area += area_vector(mesh, f).norm();
    for (const int v : mesh.faces.col(f))
      parts[p].box.extend(Eigen::Vector3d(mesh.vertices.col(v)));
    diagnosis.area += area_vector(mesh, f).norm();
  }
  for (std::size_t i = 0; i < edges.size();) {
    const std::size_t end = edge_end(edges, i);
    if (end - i != 2) parts[part_of_face[edges[i].face]].closed = false;
    i = end;
  }
  OpenBorder border = open_border(agreeing);
  for (const OpenLoop& loop : border.loops) {
    diagnosis.part_of_loop.push_back(part_of_face[loop.face]);
    ++parts[part_of_face[loop.face]].open_loops;
  }
  diagnosis.loops = std::move(border.loops);
  std::vector<double> volumes(parts.size(), 0);
  const Eigen::Vector3d center = bounding_box(mesh).center();
  for (int f = 0; f < mesh.face_count(); ++f)
    if (part_of_face[f] >= 0)
      volumes[part_of_face[f]] +=
          area_vector(agreeing, f).dot(mesh.vertices.col(mesh.faces(0, f)) - center) / 3;
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (parts[p].closed) parts[p].volume = std::abs(volumes[p]);
  diagnosis.t_junctions = count_t_junctions(mesh, default_weld(mesh));
  if (parts.size() > 1) add_overlaps(agreeing, part_of_face, diagnosis);
  return diagnosis;
}

std::optional<Remedy> remedy_for(const TriMesh& mesh) {
  for (const MendOptions& options : candidates(mesh)) {
    const MendedMesh mended_mesh = mended(mesh, options);
    if (mended_mesh.failures.empty() && mended_mesh.report.sound())
      return Remedy{options, mended_mesh.report.volume};
  }
  return std::nullopt;
}

}  // namespace hydro
