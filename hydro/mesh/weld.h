#pragma once

#include <vector>

#include "hydro/mesh/mesh.h"

namespace hydro {

/// Returns the mesh with vertices merged that differ by at most `tolerance` [m] along every axis:
/// each vertex joins the earliest kept vertex within the tolerance, whose position remains. Faces
/// that lose a corner and vertices that no face names are dropped; the rest keep their order. The
/// time is linear. Vertices must be finite.
TriMesh welded(const TriMesh& mesh, double tolerance);

/// Returns the mesh with the vertices of a list merged as `welded` does, and no others.
TriMesh welded_among(const TriMesh& mesh, const std::vector<int>& vertices, double tolerance);

}  // namespace hydro
