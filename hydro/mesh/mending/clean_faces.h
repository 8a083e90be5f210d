#pragma once

#include "hydro/mesh/mesh.h"

/// @file
/// Removes faces that bound nothing. The order of the others is kept.

namespace hydro {

/// The mesh without faces flatter than 1e-12 of their longest edge. Where three vertices lie on a
/// line, that in the middle then lies on the side of a neighbour (see stitched).
TriMesh without_flat_faces(const TriMesh& mesh);

/// The mesh without repeated faces. The first of several faces with the same vertices remains. Two
/// faces that look in opposite directions and divide a solid, as where two boxes share a face, are
/// both removed: faces whose sheet is bounded by edges with two other faces.
TriMesh without_duplicate_faces(const TriMesh& mesh);

/// The mesh without walls inside it: sheets of faces that end at edges with two other faces at
/// least, and that no ray in 26 directions reaches from outside.
TriMesh without_inner_walls(const TriMesh& mesh);

/// Splits faces at vertices of open edges that lie on their sides, within a tolerance [m], so that
/// T-junctions close; vertices nearer to an end of the side than ten times that do not count. A
/// mesh that does not have fewer open edges then stays as it is.
TriMesh stitched(const TriMesh& mesh, double tolerance);

/// Number of vertices of open edges that lie on the open side of a face [-].
Eigen::Index count_t_junctions(const TriMesh& mesh, double tolerance);

}  // namespace hydro
