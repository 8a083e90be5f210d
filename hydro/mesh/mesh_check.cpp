#include "hydro/mesh/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "hydro/mesh/edge_table.h"
#include "hydro/mesh/face_tree.h"
#include "hydro/mesh/mesh_overlap.h"
#include "hydro/mesh/mesh_parts.h"

namespace hydro {
namespace {

using Finding = MeshReport::Finding;

/// Height of a triangle over its longest edge, relative to that edge, below which it has no area.
/// At this limit round-off leaves four digits of the normal; meshes from files of floats stay far
/// above it unless three vertices are exactly collinear.
constexpr double kFlat = 1e-12;

/// Volume below which nothing is enclosed, relative to area times extent: the round-off of the sum.
constexpr double kNoVolume = 1e-14;

void add(Finding& finding, const Eigen::Vector3d& place) {
  if (finding.count++ == 0) finding.first = place;
}

Eigen::Vector3d middle(const TriMesh& mesh, Eigen::Index face) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int v : mesh.faces.col(face)) sum += mesh.vertices.col(v);
  return sum / 3;
}

Eigen::Vector3d middle(const TriMesh& mesh, const HalfEdge& edge) {
  return (mesh.vertices.col(edge.low) + mesh.vertices.col(edge.high)) / 2;
}

/// The vertex of the half-edge's face that is not on the edge.
int third_vertex(const TriMesh& mesh, const HalfEdge& edge) {
  return mesh.faces.col(edge.face).sum() - edge.low - edge.high;
}

/// Finds faces on one edge that share the third vertex with an earlier face. Each face is checked
/// on one edge only, that of its two lowest vertices.
void find_duplicates(const TriMesh& mesh, const HalfEdge* begin, const HalfEdge* end,
                     Finding& duplicates) {
  std::vector<std::pair<int, int>> thirds;  // third vertex, face
  for (const HalfEdge* edge = begin; edge != end; ++edge) {
    const int third = third_vertex(mesh, *edge);
    if (third > edge->high) thirds.emplace_back(third, edge->face);
  }
  std::sort(thirds.begin(), thirds.end());
  for (std::size_t i = 1; i < thirds.size(); ++i)
    if (thirds[i].first == thirds[i - 1].first) add(duplicates, middle(mesh, thirds[i].second));
}

void check_edges(const TriMesh& mesh, const std::vector<HalfEdge>& edges, MeshReport& report) {
  for (std::size_t i = 0; i < edges.size();) {
    const std::size_t end = edge_end(edges, i);
    const Eigen::Vector3d place = middle(mesh, edges[i]);
    if (end - i == 1) add(report.open_edges, place);
    if (end - i > 2) add(report.crowded_edges, place);
    if (end - i == 2 && edges[i].rising == edges[i + 1].rising)
      add(report.misoriented_edges, place);
    if (end - i > 1)
      find_duplicates(mesh, edges.data() + i, edges.data() + end, report.duplicate_faces);
    i = end;
  }
}

/// Volume of a closed mesh, summed about the centre of its box, and the round-off of the sum [m^3].
struct Volume {
  double value = 0;
  double rounding = 0;
};

Volume signed_volume(const TriMesh& mesh) {
  const Eigen::AlignedBox3d box = bounding_box(mesh);
  Volume volume;
  double area = 0;
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    const Eigen::Vector3d a = area_vector(mesh, f);
    area += a.norm();
    volume.value += a.dot(mesh.vertices.col(mesh.faces(0, f)) - box.center()) / 3;
  }
  if (area > 0) volume.rounding = kNoVolume * area * box.diagonal().norm();
  return volume;
}

/// Checks each part separately, because the volumes of parts with opposite orientations may cancel.
void check_parts(const std::vector<MeshPart>& parts, double rounding, MeshReport& report,
                 const TriMesh& mesh) {
  Eigen::Index solid = 0;
  for (const MeshPart& part : parts) {
    if (std::abs(part.volume) <= rounding) continue;
    ++solid;
    if (part.misturned()) add(report.misturned_parts, middle(mesh, part.first_face));
  }
  report.empty = solid == 0;
  report.inward = solid > 0 && report.misturned_parts.count == solid;
  if (report.inward) report.misturned_parts = {};
}

void check_solid(const TriMesh& mesh, const std::vector<HalfEdge>& edges, const FaceTree& tree,
                 MeshReport& report) {
  const Volume volume = signed_volume(mesh);
  report.volume = volume.value;
  report.empty = std::abs(volume.value) <= volume.rounding;
  if (report.misoriented_edges.count > 0 || report.duplicate_faces.count > 0) return;
  if (report.self_overlaps.count == 0)
    check_parts(closed_parts(mesh, edges, tree), volume.rounding, report, mesh);
  else
    report.inward = volume.value < -volume.rounding;
}

void check_shape(const TriMesh& mesh, const std::vector<HalfEdge>& edges, MeshReport& report) {
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f)
    if (has_no_area(mesh, f)) add(report.degenerate_faces, middle(mesh, f));
  const FaceTree tree(mesh);
  const Overlaps overlaps = find_overlaps(mesh, tree);
  report.self_overlaps = {overlaps.count, overlaps.first};
  if (report.closed()) check_solid(mesh, edges, tree, report);
}

void require_vertices(const TriMesh& mesh) {
  if (mesh.face_count() == 0) return;
  if (mesh.faces.minCoeff() < 0 || mesh.faces.maxCoeff() >= mesh.vertex_count())
    throw std::invalid_argument(
        "a face names vertex " +
        std::to_string(mesh.faces.minCoeff() < 0 ? mesh.faces.minCoeff() : mesh.faces.maxCoeff()) +
        ", expected 0 to " + std::to_string(mesh.vertex_count() - 1));
}

/// "3 edges are open, the first at (0.5, 0, 1)"; `one` or `many` follows the number.
void tell(std::vector<std::string>& sentences, const Finding& finding, const char* one,
          const char* many) {
  if (finding.count == 0) return;
  std::ostringstream text;
  text << finding.count << ' ' << (finding.count == 1 ? one : many)
       << (finding.count == 1 ? ", at (" : ", the first at (") << finding.first.x() << ", "
       << finding.first.y() << ", " << finding.first.z() << ')';
  sentences.push_back(text.str());
}

}  // namespace

bool has_no_area(const TriMesh& mesh, Eigen::Index face) {
  const Eigen::Vector3d a = mesh.vertices.col(mesh.faces(0, face));
  const Eigen::Vector3d b = mesh.vertices.col(mesh.faces(1, face));
  const Eigen::Vector3d c = mesh.vertices.col(mesh.faces(2, face));
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return !((b - a).cross(c - a).norm() > kFlat * longest);
}

bool MeshReport::sound() const { return describe(*this).empty(); }

MeshReport check_mesh(const TriMesh& mesh) {
  require_vertices(mesh);
  MeshReport report;
  for (const auto& p : mesh.vertices.colwise())
    if (!p.allFinite()) add(report.not_finite, p);
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  check_edges(mesh, edges, report);
  if (report.not_finite.count == 0) check_shape(mesh, edges, report);
  return report;
}

std::vector<std::string> describe(const MeshReport& report) {
  std::vector<std::string> all;
  tell(all, report.not_finite, "vertex is not finite", "vertices are not finite");
  tell(all, report.open_edges, "edge is open (one face only)", "edges are open (one face only)");
  tell(all, report.crowded_edges, "edge has more than two faces", "edges have more than two faces");
  tell(all, report.misoriented_edges, "edge has its two faces turned against each other",
       "edges have their two faces turned against each other");
  tell(all, report.degenerate_faces, "face has no area", "faces have no area");
  tell(all, report.duplicate_faces, "face has the same vertices as an earlier one",
       "faces have the same vertices as an earlier one");
  tell(all, report.self_overlaps, "pair of faces cuts through each other",
       "pairs of faces cut through each other");
  tell(all, report.misturned_parts,
       "closed part is turned the wrong way: a cavity must face inward, a solid outward",
       "closed parts are turned the wrong way: a cavity must face inward, a solid outward");
  if (report.inward) all.push_back("the normals point into the solid");
  if (report.empty) all.push_back("the mesh encloses no volume");
  return all;
}

RepairedMesh repaired(TriMesh mesh) {
  RepairedMesh result{std::move(mesh), {}, {}};
  result.report = check_mesh(result.mesh);
  if (!result.report.inward) return result;
  result.mesh = flipped(std::move(result.mesh));
  result.report.inward = false;
  result.report.volume = -result.report.volume;
  result.notes.push_back("the normals pointed into the solid; all faces were turned over");
  return result;
}

}  // namespace hydro
