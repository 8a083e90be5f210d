#pragma once

#include "hydro/mesh/mesh.h"
#include "hydro/sea.h"

/// @file
/// The ground of a height field as a mesh.

namespace hydro {

/// Returns the ground described by a height field, as an open surface of upward-facing triangles in
/// W with heights above z = 0. Each cell has two triangles; diagonals alternate from cell to cell,
/// so neither direction is favoured. Where the four corners of a cell are not coplanar, the mesh
/// departs from the field's bilinear surface by at most a quarter of their twist.
/// @throws std::invalid_argument if the field has fewer than two rows or columns, or its cell is
///         not positive.
TriMesh terrain_mesh(const HeightField& field);

}  // namespace hydro
