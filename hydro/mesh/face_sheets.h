#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "hydro/mesh/edge_table.h"

namespace hydro {

/// Faces joined into sets, each named by its lowest face.
class FaceSheets {
 public:
  explicit FaceSheets(Eigen::Index faces) : parent_(static_cast<std::size_t>(faces)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int of(int face) {
    while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]];
    return face;
  }
  void join(int f, int g) {
    f = of(f);
    g = of(g);
    parent_[std::max(f, g)] = std::min(f, g);
  }

 private:
  std::vector<int> parent_;
};

/// Joins the faces that meet at an edge with no others.
inline FaceSheets sheets_of(const std::vector<HalfEdge>& edges, Eigen::Index faces) {
  FaceSheets sheets(faces);
  for (std::size_t i = 0; i < edges.size();) {
    const std::size_t end = edge_end(edges, i);
    if (end - i == 2) sheets.join(edges[i].face, edges[i + 1].face);
    i = end;
  }
  return sheets;
}

}  // namespace hydro
