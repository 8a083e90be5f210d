#pragma once

#include <optional>

#include "hydro/mesh/mesh.h"

namespace hydro {

/// Returns a mesh of one half with its mirror image in the plane through the origin normal to an
/// axis. Vertices within a tolerance of the plane are moved onto it and join the halves; faces in
/// it are dropped. None if vertices lie on both sides of the plane.
/// @param axis        0, 1 or 2: x, y or z.
/// @param tolerance   [m]
std::optional<TriMesh> with_mirror_image(TriMesh mesh, int axis, double tolerance);

}  // namespace hydro
