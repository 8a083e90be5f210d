#pragma once

#include <vector>

#include "hydro/mesh/mesh.h"

namespace hydro {

/// Splits faces at vertices that lie on their sides, so that neighbours share whole edges. The
/// parts of a face take its place.
/// @param vertices   Vertices that may lie on sides.
/// @param margin     Distance up to which a vertex lies on a side [m].
/// @param from_ends  Least distance of a vertex from the ends of the side [m].
/// @param faces      Per face, true if it may be split; empty: all may.
TriMesh split_sides(const TriMesh& mesh, std::vector<int> vertices, double margin, double from_ends,
                    const std::vector<char>& faces = {});

}  // namespace hydro
