#pragma once

#include <functional>
#include <vector>

#include "hydro/mesh/edge_table.h"
#include "hydro/mesh/face_tree.h"
#include "hydro/mesh/mesh.h"

/// @file
/// The closed parts of a mesh: sets of faces connected by edges.

namespace hydro {

struct MeshPart {
  int first_face = 0;     ///< Lowest face index of the part.
  double volume = 0;      ///< Signed by the orientation [m^3].
  bool in_other = false;  ///< True if inside an odd number of other parts.

  /// True if the sign of the volume is wrong: it must be negative if in_other, else positive.
  bool misturned() const { return in_other ? volume > 0 : volume < 0; }
};

/// True if most of some faces, three of a part say, start inside the faces that count: a ray from
/// their middles meets an odd number of these. One face alone may lie on the surface of another
/// part.
bool lie_inside(const TriMesh& mesh, const FaceTree& tree, const std::vector<int>& faces,
                const std::function<bool(int)>& counts);

/// Returns the number of the part that each face belongs to, in the order of their lowest faces;
/// parts need not be closed. −1 for a face that names a vertex twice.
std::vector<int> part_of_faces(const TriMesh& mesh, const std::vector<HalfEdge>& edges);

/// Returns the parts in the order of their lowest face. The mesh must be closed, consistently
/// oriented and free of overlaps; `edges` and `tree` must belong to it.
std::vector<MeshPart> closed_parts(const TriMesh& mesh, const std::vector<HalfEdge>& edges,
                                   const FaceTree& tree);

}  // namespace hydro
