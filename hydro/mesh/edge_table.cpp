#include "hydro/mesh/edge_table.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace hydro {
namespace {

std::array<HalfEdge, 3> sides(const TriMesh& mesh, int face) {
  std::array<HalfEdge, 3> result;
  for (int i = 0; i < 3; ++i) {
    const int from = mesh.faces(i, face), to = mesh.faces((i + 1) % 3, face);
    result[i] = {std::min(from, to), std::max(from, to), face, from < to};
  }
  return result;
}

bool before(const HalfEdge& a, const HalfEdge& b) {
  return std::tie(a.high, a.face) < std::tie(b.high, b.face);
}

}  // namespace

bool repeats_vertex(const TriMesh& mesh, Eigen::Index face) {
  const auto f = mesh.faces.col(face);
  return f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
}

std::vector<HalfEdge> sorted_half_edges(const TriMesh& mesh) {
  // Counting sort by the lower vertex; the few half-edges of a vertex are then sorted by
  // comparison.
  std::vector<std::size_t> start(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0);
  const int faces = static_cast<int>(mesh.face_count());
  for (int f = 0; f < faces; ++f)
    if (!repeats_vertex(mesh, f))
      for (const HalfEdge& side : sides(mesh, f)) ++start[side.low + 1];
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];

  std::vector<HalfEdge> sorted(start.back());
  std::vector<std::size_t> next = start;
  for (int f = 0; f < faces; ++f)
    if (!repeats_vertex(mesh, f))
      for (const HalfEdge& side : sides(mesh, f)) sorted[next[side.low]++] = side;
  for (std::size_t v = 0; v + 1 < start.size(); ++v)
    std::sort(sorted.data() + start[v], sorted.data() + start[v + 1], before);
  return sorted;
}

std::size_t edge_end(const std::vector<HalfEdge>& sorted, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < sorted.size() && sorted[end].low == sorted[begin].low &&
         sorted[end].high == sorted[begin].high)
    ++end;
  return end;
}

}  // namespace hydro
