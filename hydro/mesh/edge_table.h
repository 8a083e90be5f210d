#pragma once

#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// The edges of a triangle mesh with the faces that meet there.

namespace hydro {

/// A side of a face.
struct HalfEdge {
  int low, high;  ///< Vertices of the edge, low < high.
  int face;
  bool rising;  ///< True if the face traverses the edge from low to high.
};

/// Returns the sides of all faces, sorted by (low, high, face), so that the sides on one edge are
/// adjacent. Faces that name a vertex twice are left out. The time is linear.
std::vector<HalfEdge> sorted_half_edges(const TriMesh& mesh);

/// Returns the end of the run of half-edges on one edge that starts at `begin`.
std::size_t edge_end(const std::vector<HalfEdge>& sorted, std::size_t begin);

/// True if a face names a vertex twice.
bool repeats_vertex(const TriMesh& mesh, Eigen::Index face);

}  // namespace hydro
