#pragma once

#include "hydro/mesh/mesh.h"

namespace hydro {

/// Returns the mesh with vertices merged that differ by at most `tolerance` [m] along every axis:
/// each vertex joins the earliest kept vertex within the tolerance, whose position remains. Faces
/// that lose a corner and vertices that no face names are dropped; the rest keep their order. The
/// time is linear. Vertices must be finite.
TriMesh welded(const TriMesh& mesh, double tolerance);

}  // namespace hydro
