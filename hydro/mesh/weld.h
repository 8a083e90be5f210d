#pragma once

#include "hydro/mesh/mesh.h"

namespace hydro {

/// The mesh with vertices that differ by at most `tolerance` [m] along every axis made one: each
/// joins the earliest vertex kept within reach, which keeps its place. Faces that lose a corner by
/// this are dropped, as are vertices that no face names; what remains keeps its order. Linear in
/// time. Vertices must be finite.
TriMesh welded(const TriMesh& mesh, double tolerance);

}  // namespace hydro
