#pragma once

#include "hydro/interior/pockets.h"

/// @file
/// The body that a hollow one is for the sea outside: its pockets are closed by lids.

namespace hydro {

/// The mesh without the faces of its pockets, each mouth closed by a lid over its sill, and voids
/// left out. Lids are triangulated in the mean plane of each loop of the sill, by cutting off the
/// best corner; the rest, if none can be cut off, about a vertex in its middle. The result is
/// closed and outward; vertices that no face names are left out.
/// @param division   find_pockets() of the mesh.
TriMesh with_lids(const TriMesh& mesh, const Pockets& division);

}  // namespace hydro
