#pragma once

#include "app/render/shaded_mesh.h"

namespace render {

/// How open the space over each vertex of a skin is, 0 … 1: the share of the directions over its
/// surface, weighted by their cosine, in which nothing of the mesh stands. Found with up to 48
/// directions a vertex, fewer for many vertices, so that it takes no more than about half a second;
/// 1 everywhere for a skin of more than 50,000 vertices, and at once for a convex one.
///
/// @param mesh   That the skin is of.
Eigen::RowVectorXf openness(const hydro::TriMesh& mesh, const ShadedMesh& skin);

}  // namespace render
