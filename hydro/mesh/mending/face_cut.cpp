#include "hydro/mesh/mending/face_cut.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "hydro/mesh/face_tree.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// Six times the volume of the tetrahedron of four vertices, positive if the first lies behind the
/// face of the others. It is computed in one order of the vertices, so that faces which share some
/// of them agree to the last digit.
double six_volumes(const TriMesh& mesh, std::array<int, 4> v) {
  bool odd = false;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3 - i; ++j)
      if (v[j] > v[j + 1]) {
        std::swap(v[j], v[j + 1]);
        odd = !odd;
      }
  const Vector3d p = mesh.vertices.col(v[0]);
  const Vector3d a = mesh.vertices.col(v[1]), b = mesh.vertices.col(v[2]),
                 c = mesh.vertices.col(v[3]);
  const double volume = (a - p).dot((b - p).cross(c - p));
  return odd ? -volume : volume;
}

/// How an edge meets a face of the other mesh.
enum class Meeting { none, enters, leaves, degenerate };

class FaceCutter {
 public:
  FaceCutter(const TriMesh& both, int first) : mesh_(both), first_(first) {
    for (const auto& v : both.vertices.colwise()) result_.vertices.emplace_back(v);
    result_.cuts.resize(static_cast<std::size_t>(both.face_count()));
  }

  std::optional<CutFaces> cut() {
    const FaceTree tree(mesh_);
    for (int leaf = 0; leaf < tree.leaf_count(); ++leaf)
      tree.visit_pairs(leaf, [&](int f, int g) {
        if ((f < first_) != (g < first_)) cut_pair(std::min(f, g), std::max(f, g));
      });
    if (degenerate_) return std::nullopt;
    for (FaceCut& cut : result_.cuts)
      std::ranges::sort(cut.edge_points, {},
                        [](const EdgePoint& p) { return std::tuple(p.side, p.at, p.vertex); });
    return std::move(result_);
  }

 private:
  Meeting meet(int from, int to, int face) {
    const auto g = mesh_.faces.col(face);
    const double a = six_volumes(mesh_, {from, g[0], g[1], g[2]});
    const double b = six_volumes(mesh_, {to, g[0], g[1], g[2]});
    if ((a > 0 && b > 0) || (a < 0 && b < 0)) return Meeting::none;
    double least = 0, largest = 0;
    bool zero = a == 0 || b == 0;
    for (int i = 0; i < 3; ++i) {
      const double side = six_volumes(mesh_, {from, to, g[i], g[(i + 1) % 3]});
      least = std::min(least, side);
      largest = std::max(largest, side);
      zero = zero || side == 0;
    }
    if (least < 0 && largest > 0) return Meeting::none;
    if (zero) return Meeting::degenerate;
    return a < 0 ? Meeting::enters : Meeting::leaves;
  }

  /// Returns the point where an edge passes through a face; its share of the edge from `from` goes
  /// to `at`.
  int point(int from, int to, int face, double& at) {
    const auto [low, high] = std::minmax(from, to);
    const auto g = mesh_.faces.col(face);
    const double a = six_volumes(mesh_, {low, g[0], g[1], g[2]});
    const double b = six_volumes(mesh_, {high, g[0], g[1], g[2]});
    const double share = a / (a - b);
    at = from == low ? share : 1 - share;
    const auto [known, is_new] =
        points_.emplace(std::tuple(low, high, face), static_cast<int>(result_.vertices.size()));
    if (is_new)
      result_.vertices.push_back(mesh_.vertices.col(low) +
                                 share * (mesh_.vertices.col(high) - mesh_.vertices.col(low)));
    return known->second;
  }

  /// Finds where the sides of a face pass through another. The segment of the cut on the first face
  /// of the pair, with the second mesh on its left, begins where that face's own side leaves the
  /// second mesh, or a side of the second face enters the first.
  void add_sides(int face, int other, bool of_first, std::array<int, 2>& segment, int& count) {
    for (int i = 0; i < 3; ++i) {
      const int from = mesh_.faces(i, face), to = mesh_.faces((i + 1) % 3, face);
      const Meeting meeting = meet(from, to, other);
      degenerate_ = degenerate_ || meeting == Meeting::degenerate;
      if (meeting == Meeting::none || meeting == Meeting::degenerate) continue;
      const bool enters = meeting == Meeting::enters;
      EdgePoint on_edge{.side = i, .enters = enters};
      on_edge.vertex = point(from, to, other, on_edge.at);
      result_.cuts[face].edge_points.push_back(on_edge);
      int& end = segment[enters == of_first ? 1 : 0];
      degenerate_ = degenerate_ || end >= 0;
      end = on_edge.vertex;
      ++count;
    }
  }

  void cut_pair(int f, int g) {
    std::array<int, 2> segment = {-1, -1};
    int count = 0;
    add_sides(f, g, true, segment, count);
    add_sides(g, f, false, segment, count);
    if (count == 0) return;
    if (count != 2 || segment[0] < 0 || segment[1] < 0) {
      degenerate_ = true;
      return;
    }
    result_.cuts[f].segments.push_back(segment);
    result_.cuts[g].segments.push_back({segment[1], segment[0]});
  }

  const TriMesh& mesh_;
  int first_;
  CutFaces result_;
  std::map<std::tuple<int, int, int>, int> points_;  ///< By the ends of the edge and the face.
  bool degenerate_ = false;
};

}  // namespace

std::optional<CutFaces> cut_faces(const TriMesh& both, int first) {
  return FaceCutter(both, first).cut();
}

}  // namespace hydro
