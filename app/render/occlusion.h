#pragma once

#include "app/render/shaded_mesh.h"

namespace render {

/// Returns the openness of each vertex of a shaded mesh, 0 … 1: the cosine-weighted share of
/// directions above the surface in which no ray meets the mesh. Each vertex gets up to 48 rays,
/// fewer where vertices are many, which bounds the time to about half a second. Convex meshes and
/// shaded meshes of more than 50,000 vertices are open everywhere (1).
///
/// @param mesh   Mesh that `skin` was made from.
Eigen::RowVectorXf openness(const hydro::TriMesh& mesh, const ShadedMesh& skin);

}  // namespace render
