#include "hydro/mesh/open_loops.h"

#include <algorithm>

#include "hydro/mesh/edge_table.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// Distance from its plane up to which a loop is flat, relative to its extent: hulls are drawn to a
/// millimetre per metre, and a cap changes the volume by as little.
constexpr double kFlatLoop = 1e-3;

/// Area over the square of the length below which a loop is a line. A circle has 0.08, and a gap
/// between two sides of a length L has half its width over L.
constexpr double kLineLoop = 1e-6;

/// An open edge in the direction in which a face that fills it would go.
struct OpenEdge {
  int from, to, face;
};

std::vector<OpenEdge> open_edges_of(const TriMesh& mesh) {
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  std::vector<OpenEdge> open;
  for (std::size_t i = 0; i < edges.size();) {
    const std::size_t end = edge_end(edges, i);
    const HalfEdge& edge = edges[i];
    if (end - i == 1)
      open.push_back(
          {edge.rising ? edge.high : edge.low, edge.rising ? edge.low : edge.high, edge.face});
    i = end;
  }
  std::ranges::sort(open, {}, [](const OpenEdge& e) { return std::pair(e.from, e.to); });
  return open;
}

OpenLoop measured(const TriMesh& mesh, std::vector<int> vertices, int face) {
  OpenLoop loop{.vertices = std::move(vertices), .face = face};
  const std::size_t n = loop.vertices.size();
  const auto at = [&](std::size_t i) { return Vector3d(mesh.vertices.col(loop.vertices[i % n])); };
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < n; ++i) {
    loop.middle += at(i) / static_cast<double>(n);
    loop.length += (at(i + 1) - at(i)).norm();
    box.extend(at(i));
  }
  Vector3d twice_area = Vector3d::Zero();
  for (std::size_t i = 0; i < n; ++i)
    twice_area += (at(i) - loop.middle).cross(at(i + 1) - loop.middle);
  loop.area = twice_area.norm() / 2;
  loop.extent = box.sizes().maxCoeff();
  if (loop.area <= kLineLoop * loop.length * loop.length) {
    loop.shape = LoopShape::line;
    return loop;
  }
  loop.normal = twice_area.normalized();
  for (std::size_t i = 0; i < n; ++i)
    loop.off_plane = std::max(loop.off_plane, std::abs(loop.normal.dot(at(i) - loop.middle)));
  loop.shape = loop.off_plane <= kFlatLoop * loop.extent ? LoopShape::flat : LoopShape::bent;
  return loop;
}

/// Walks along open edges and cuts off a loop wherever the way meets itself.
class BorderTracer {
 public:
  explicit BorderTracer(const TriMesh& mesh)
      : mesh_(mesh),
        edges_(open_edges_of(mesh)),
        used_(edges_.size(), 0),
        place_(static_cast<std::size_t>(mesh.vertex_count()), -1) {}

  OpenBorder trace() {
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (!used_[e]) walk(edges_[e].from);
    return std::move(border_);
  }

 private:
  /// Returns an unused edge from a vertex; the number of edges if there is none.
  std::size_t edge_from(int vertex) const {
    auto e = static_cast<std::size_t>(
        std::ranges::lower_bound(edges_, vertex, {}, &OpenEdge::from) - edges_.begin());
    while (e < edges_.size() && edges_[e].from == vertex && used_[e]) ++e;
    return e < edges_.size() && edges_[e].from == vertex ? e : edges_.size();
  }

  void walk(int start) {
    std::vector<int> way = {start};
    place_[start] = 0;
    for (std::size_t e = edge_from(start); e < edges_.size(); e = edge_from(way.back())) {
      used_[e] = 1;
      const int to = edges_[e].to, place = place_[to];
      if (place < 0) {
        place_[to] = static_cast<int>(way.size());
        way.push_back(to);
        continue;
      }
      border_.loops.push_back(measured(mesh_, {way.begin() + place, way.end()}, edges_[e].face));
      while (static_cast<int>(way.size()) > place + 1) {
        place_[way.back()] = -1;
        way.pop_back();
      }
    }
    border_.loose_edges += static_cast<Eigen::Index>(way.size()) - 1;
    for (const int v : way) place_[v] = -1;
  }

  const TriMesh& mesh_;
  std::vector<OpenEdge> edges_;  ///< Ascending in their starts.
  std::vector<char> used_;
  std::vector<int> place_;  ///< Place of each vertex on the way; −1 if it is not on it.
  OpenBorder border_;
};

}  // namespace

OpenBorder open_border(const TriMesh& mesh) { return BorderTracer(mesh).trace(); }

std::vector<int> open_vertices(const TriMesh& mesh) {
  std::vector<int> vertices;
  for (const OpenEdge& edge : open_edges_of(mesh)) {
    vertices.push_back(edge.from);
    vertices.push_back(edge.to);
  }
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace hydro
