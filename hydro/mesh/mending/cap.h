#pragma once

#include "hydro/mesh/mesh.h"

namespace hydro {

/// A mesh after its flat loops were filled.
struct CappedMesh {
  TriMesh mesh;
  int loops = 0;  ///< Number of loops that were filled.
};

/// Fills the flat open loops of a mesh by faces in their planes. A loop inside another one in its
/// plane is a hole in the other's cap if it runs the other way around: a tube's wall is closed, not
/// its bore. The loop around a flat part, which would be doubled, stays open. The faces of a part
/// must be oriented consistently.
CappedMesh capped(const TriMesh& mesh);

}  // namespace hydro
