#pragma once

#include <Eigen/Core>
#include <optional>

#include "app/render/body_appearance.h"
#include "app/render/texture_map.h"
#include "hydro/mesh/face_tree.h"

namespace render {

/// Finds the texture coordinates of a triangle's corners on a painted surface that may be cut into
/// other triangles: drawn meshes are welded, split, mended or coarser than their file.
/// @param tree      Tree of the paint's surface.
/// @param corners   Corners of the triangle, one a column [m, B].
/// @param face      Triangle of the surface nearest to its middle; it has a texture.
/// @return none where the triangle does not lie on the surface, or where the surface's coordinates
///     are not nearly linear over it, as across a seam
std::optional<CornerCoordinates> fitted_coordinates(const hydro::FaceTree& tree, const Paint& paint,
                                                    const Eigen::Matrix3d& corners, int face);

}  // namespace render
