#pragma once

#include "app/render/body_appearance.h"
#include "app/render/shaded_mesh.h"

namespace render {

/// A shaded mesh whose triangles have a colour each.
struct PaintedSkin {
  ShadedMesh skin;
  Eigen::Matrix3Xf colors;  ///< Colour of each vertex, RGB 0 … 1; equal at a triangle's corners.
};

/// Gives each triangle the colour that the paint has nearest to its middle. A vertex between
/// colours appears once for each.
/// @param own   Colour where the paint has none.
PaintedSkin painted_skin(const ShadedMesh& skin, const Paint& paint, const Eigen::Vector3f& own);

}  // namespace render
