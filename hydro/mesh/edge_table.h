#pragma once

#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// The edges of a triangle mesh with the faces that meet there.

namespace hydro {

/// A side of a face.
struct HalfEdge {
  int low, high;  ///< Its vertices, low < high.
  int face;
  bool rising;  ///< The face runs it from low to high.
};

/// The sides of all faces, sorted by (low, high, face), so that those of one edge stand together.
/// Faces that name a vertex twice have no proper sides and are left out. Linear in time.
std::vector<HalfEdge> sorted_half_edges(const TriMesh& mesh);

/// The end of the run of half-edges that starts at `begin` and lies on one edge.
std::size_t edge_end(const std::vector<HalfEdge>& sorted, std::size_t begin);

/// True if a face names a vertex twice.
bool repeats_vertex(const TriMesh& mesh, Eigen::Index face);

}  // namespace hydro
