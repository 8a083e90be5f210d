#pragma once

#include <vector>

#include "hydro/mesh/edge_table.h"
#include "hydro/mesh/face_tree.h"
#include "hydro/mesh/mesh.h"

/// @file
/// The closed parts of a mesh: sets of faces that hang together by edges.

namespace hydro {

struct MeshPart {
  int first_face = 0;     ///< Its lowest face.
  double volume = 0;      ///< Signed by its orientation [m^3].
  bool in_other = false;  ///< Inside an odd number of the other parts.

  /// A part is right if it adds to the solid outside and takes away inside.
  bool misturned() const { return in_other ? volume > 0 : volume < 0; }
};

/// Parts in the order of their lowest face. The mesh must be closed and its faces consistent, free
/// of cuts through each other; `edges` and `tree` must be of this mesh.
std::vector<MeshPart> closed_parts(const TriMesh& mesh, const std::vector<HalfEdge>& edges,
                                   const FaceTree& tree);

}  // namespace hydro
