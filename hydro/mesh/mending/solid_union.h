#pragma once

#include <optional>
#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// The union of closed meshes that overlap.

namespace hydro {

/// Returns the union of closed meshes whose faces look outward; cavities stay. Faces are cut where
/// they meet those of another mesh, and what lies inside another mesh is dropped. The points of the
/// cut are found once for each edge and face, so that the result closes without a tolerance. Where
/// meshes meet in faces, edges or vertices of both, one is moved by some millionths of the size.
/// Meshes that touch or lie apart are joined as in mesh_union.h.
/// @return none if no solid results, as from meshes that cut themselves
std::optional<TriMesh> united(const std::vector<TriMesh>& solids);

/// Splits a closed mesh into its solids: each part that looks outward with the cavities in it.
std::vector<TriMesh> solids_of(const TriMesh& mesh);

}  // namespace hydro
