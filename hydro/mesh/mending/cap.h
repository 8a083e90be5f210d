#pragma once

#include "hydro/mesh/mesh.h"

namespace hydro {

/// A mesh after its flat loops were filled.
struct CappedMesh {
  TriMesh mesh;
  int loops = 0;  ///< Number of loops that were filled.
};

/// Fills the flat open loops of a mesh by faces in their planes. Of loops in one plane, one inside
/// another that runs the other way around is a hole in its cap: a tube's wall is closed, not its
/// bore. The loop around a flat part, which would be doubled, stays open. The faces of a part must
/// be oriented consistently.
CappedMesh capped(const TriMesh& mesh);

}  // namespace hydro
