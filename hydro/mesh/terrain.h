#pragma once

#include "hydro/mesh/mesh.h"
#include "hydro/sea.h"

namespace hydro {

/// The ground that a height field describes, as an open surface of triangles that look up, in W:
/// two a cell, heights above z = 0, diagonals alternating from cell to cell so that none of the two
/// directions is favoured. Where the four corners of a cell are not in a plane it departs from the
/// field's bilinear surface by at most a quarter of their twist.
/// @throws std::invalid_argument if the field has fewer than two rows or columns, or its cell is
/// not
///         positive.
TriMesh terrain_mesh(const HeightField& field);

}  // namespace hydro
