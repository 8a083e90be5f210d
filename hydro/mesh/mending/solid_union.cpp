#include "hydro/mesh/mending/solid_union.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "hydro/mesh/edge_table.h"
#include "hydro/mesh/face_tree.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mending/face_cut.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/mesh_parts.h"
#include "hydro/mesh/mesh_union.h"
#include "hydro/mesh/region_cut.h"
#include "hydro/mesh/weld.h"

namespace hydro {
namespace {

using Eigen::Vector3d;
using Line = std::vector<int>;

/// Shift of a mesh that is not in general position with another, over the size of both: beyond the
/// margin of mesh_overlap.h, and less than a hundredth of a per mille of any result.
constexpr double kShift = 2e-6;
constexpr int kMostShifts = 4;

/// The lines that bound the part of a cut face outside the other mesh.
class OutsideLines {
 public:
  OutsideLines(const Eigen::Vector3i& face, const FaceCut& cut) : face_(face) {
    for (const auto& [from, to] : cut.segments) whole_ = before_.emplace(to, from).second && whole_;
    for (const EdgePoint& point : cut.edge_points) {
      index_of_[point.vertex] = at_edge_.size();
      at_edge_.push_back(&point);
    }
  }

  /// Returns the lines, each with what is outside on its left; none if they do not close.
  std::optional<std::vector<Line>> lines() {
    std::vector<Line> lines;
    std::vector<char> used(at_edge_.size(), 0);
    for (std::size_t i = 0; i < at_edge_.size(); ++i) {
      if (used[i] || at_edge_[i]->enters) continue;
      lines.push_back(around(i, used));
    }
    while (whole_ && !before_.empty()) lines.push_back(along(before_.begin()->first));
    if (!whole_) return std::nullopt;
    return lines;
  }

 private:
  /// Takes the way back along the cut from a point, to its beginning or to the point itself.
  Line along(int vertex) {
    Line line = {vertex};
    for (auto next = before_.find(vertex); next != before_.end();
         next = before_.find(line.back())) {
      const int to = next->second;
      before_.erase(next);
      if (to == line.front()) return line;
      line.push_back(to);
    }
    whole_ = whole_ && index_of_.contains(line.back());
    return line;
  }

  /// Goes around the face from a point where an edge leaves the other mesh to the next, where it
  /// enters, back along the cut, and so on to the first point.
  Line around(std::size_t first, std::vector<char>& used) {
    Line line;
    std::size_t at = first;
    while (whole_ && !used[at]) {
      used[at] = 1;
      const std::size_t next = (at + 1) % at_edge_.size();
      line.push_back(at_edge_[at]->vertex);
      const int corners = next > at ? at_edge_[next]->side - at_edge_[at]->side
                                    : 3 - at_edge_[at]->side + at_edge_[next]->side;
      for (int i = 1; i <= corners; ++i) line.push_back(face_[(at_edge_[at]->side + i) % 3]);
      whole_ = whole_ && at_edge_[next]->enters;
      if (!whole_) break;
      Line back = along(at_edge_[next]->vertex);
      const auto end = index_of_.find(back.back());
      whole_ = whole_ && end != index_of_.end() && !at_edge_[end->second]->enters;
      if (!whole_) break;
      back.pop_back();
      line.insert(line.end(), back.begin(), back.end());
      at = end->second;
    }
    whole_ = whole_ && at == first;
    return line;
  }

  Eigen::Vector3i face_;
  std::map<int, int> before_;  ///< The point before each point of the cut.
  std::vector<const EdgePoint*> at_edge_;
  std::map<int, std::size_t> index_of_;
  bool whole_ = true;
};

double area_about(const std::vector<Vector3d>& vertices, const Line& line, const Vector3d& normal) {
  Vector3d sum = Vector3d::Zero();
  const Vector3d& origin = vertices[static_cast<std::size_t>(line[0])];
  for (std::size_t i = 2; i < line.size(); ++i)
    sum += (vertices[static_cast<std::size_t>(line[i - 1])] - origin)
               .cross(vertices[static_cast<std::size_t>(line[i])] - origin);
  return sum.dot(normal) / 2;
}

/// Cuts the part of a face inside lines into triangles. Lines that run clockwise are holes; where
/// the largest is a hole and none crosses the edges, the rest of the face is around it.
void add_outside(const std::vector<Vector3d>& vertices, const Eigen::Vector3i& face,
                 std::vector<Line> lines, bool edges_cut, std::vector<Eigen::Vector3i>& faces) {
  const auto at = [&](int i) { return vertices[static_cast<std::size_t>(face[i])]; };
  const Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
  const auto area = [&](const Line& line) { return area_about(vertices, line, normal); };
  std::ranges::stable_sort(lines, std::ranges::greater(),
                           [&](const Line& line) { return std::abs(area(line)); });
  if (!edges_cut && !lines.empty() && area(lines[0]) < 0)
    lines.insert(lines.begin(), Line{face[0], face[1], face[2]});
  std::vector<std::vector<Line>> holes(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (area(lines[i]) > 0) continue;
    for (std::size_t k = i; k-- > 0;) {
      if (area(lines[k]) <= 0) continue;
      if (!encloses(vertices, lines[k], normal, vertices[static_cast<std::size_t>(lines[i][0])]))
        continue;
      holes[k].push_back(lines[i]);
      break;
    }
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (area(lines[i]) > 0) cut_region(vertices, lines[i], holes[i], normal, faces);
}

TriMesh mesh_of(const std::vector<Vector3d>& vertices, const std::vector<Eigen::Vector3i>& faces) {
  TriMesh mesh{Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(vertices.size())),
               Eigen::Matrix3Xi(3, static_cast<Eigen::Index>(faces.size()))};
  for (std::size_t v = 0; v < vertices.size(); ++v)
    mesh.vertices.col(static_cast<Eigen::Index>(v)) = vertices[v];
  for (std::size_t f = 0; f < faces.size(); ++f)
    mesh.faces.col(static_cast<Eigen::Index>(f)) = faces[f];
  return welded_among(mesh, {0}, 0);  // drops the vertices that no face names
}

std::optional<TriMesh> united_pair(const TriMesh& a, const TriMesh& b) {
  const TriMesh both = side_by_side({a, b});
  const int first = static_cast<int>(a.face_count());
  const std::optional<CutFaces> cut = cut_faces(both, first);
  if (!cut) return std::nullopt;
  const FaceTree tree_a(a), tree_b(b);
  std::vector<Eigen::Vector3i> faces;
  for (int f = 0; f < both.face_count(); ++f) {
    const Eigen::Vector3i face = both.faces.col(f);
    if (cut->cuts[f].segments.empty()) {
      const Vector3d middle = both.vertices(Eigen::all, face).rowwise().mean();
      if (!(f < first ? tree_b : tree_a).contains(middle)) faces.push_back(face);
      continue;
    }
    std::optional<std::vector<Line>> lines = OutsideLines(face, cut->cuts[f]).lines();
    if (!lines) return std::nullopt;
    add_outside(cut->vertices, face, std::move(*lines), !cut->cuts[f].edge_points.empty(), faces);
  }
  return mesh_of(cut->vertices, faces);
}

/// Returns the number of the smallest solid around a cavity; −1 if there is none.
int smallest_around(const std::vector<TriMesh>& solids, const TriMesh& cavity) {
  const Vector3d p = cavity.vertices(Eigen::all, cavity.faces.col(0)).rowwise().mean();
  int found = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const double volume = solid_properties(solids[i]).volume;
    if (volume >= least || !FaceTree(solids[i]).contains(p)) continue;
    least = volume;
    found = static_cast<int>(i);
  }
  return found;
}

bool is_solid(const TriMesh& mesh) { return mesh.face_count() > 0 && check_mesh(mesh).sound(); }

/// Unites two meshes that overlap, if need be after a shift of the second.
std::optional<TriMesh> united_overlapping(const TriMesh& a, const TriMesh& b) {
  const double size = bounding_box(side_by_side({a, b})).diagonal().norm();
  for (int i = 0; i <= kMostShifts; ++i) {
    const Vector3d direction =
        Vector3d(std::sin(1.0 + 2 * i), std::sin(2.0 + 3 * i), std::cos(1.5 * i)).normalized();
    const double shift = i == 0 ? 0 : kShift * (1 + 0.3 * i) * size;
    std::optional<TriMesh> whole = united_pair(a, translated(b, shift * direction));
    if (whole && is_solid(*whole)) return whole;
  }
  return std::nullopt;
}

}  // namespace

std::optional<TriMesh> united(const std::vector<TriMesh>& solids) {
  TriMesh whole;
  for (const TriMesh& solid : solids) {
    if (whole.face_count() == 0) {
      whole = solid;
    } else if (common_part(whole, solid)) {
      std::optional<TriMesh> next = united_overlapping(whole, solid);
      if (!next) return std::nullopt;
      whole = std::move(*next);
    } else {
      TriMesh next = joined({whole, solid});
      if (!is_solid(next)) return std::nullopt;
      whole = std::move(next);
    }
  }
  return whole;
}

std::vector<TriMesh> solids_of(const TriMesh& mesh) {
  std::vector<std::vector<Eigen::Vector3i>> faces;
  const std::vector<int> part_of_face = part_of_faces(mesh, sorted_half_edges(mesh));
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (part_of_face[f] < 0) continue;
    faces.resize(std::max(faces.size(), static_cast<std::size_t>(part_of_face[f]) + 1));
    faces[static_cast<std::size_t>(part_of_face[f])].emplace_back(mesh.faces.col(f));
  }
  std::vector<Vector3d> vertices;
  for (const auto& v : mesh.vertices.colwise()) vertices.emplace_back(v);
  std::vector<TriMesh> solids, cavities;
  for (const std::vector<Eigen::Vector3i>& part : faces) {
    TriMesh one = mesh_of(vertices, part);
    (solid_properties(one).volume < 0 ? cavities : solids).push_back(std::move(one));
  }
  std::vector<std::vector<TriMesh>> groups;
  for (const TriMesh& solid : solids) groups.push_back({solid});
  for (TriMesh& cavity : cavities)
    if (const int around = smallest_around(solids, cavity); around >= 0)
      groups[static_cast<std::size_t>(around)].push_back(std::move(cavity));
  for (std::size_t i = 0; i < solids.size(); ++i) solids[i] = side_by_side(groups[i]);
  return solids;
}

}  // namespace hydro
