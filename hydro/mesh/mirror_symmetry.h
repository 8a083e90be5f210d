#pragma once

#include "hydro/mesh/mesh.h"

namespace hydro {

/// True if the vertices of a mesh are mirror images of each other in the plane through the origin
/// normal to an axis, within a tolerance [m]. Faces are not looked at.
/// @param axis   0, 1 or 2: x, y or z.
bool is_mirror_symmetric(const TriMesh& mesh, int axis, double tolerance);

}  // namespace hydro
