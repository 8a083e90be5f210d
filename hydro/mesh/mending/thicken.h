#pragma once

#include "hydro/mesh/mesh.h"

namespace hydro {

/// Returns a mesh whose open parts are plates of a thickness: each part remains as the outer side,
/// an inner side lies behind its faces at this distance, and strips along the open edges join them.
/// Closed parts stay as they are. A vertex moves so that the planes of its faces move by the
/// thickness, but by no more than ten times as far. The inner side may cut itself where the shell
/// is narrower than twice the thickness.
/// @param mesh        Its faces look outward (turned_outward).
/// @param thickness   [m], > 0.
TriMesh thickened(const TriMesh& mesh, double thickness);

}  // namespace hydro
