#pragma once

#include <vector>

#include "app/render/body_appearance.h"
#include "app/render/shaded_mesh.h"

namespace render {

/// Successive triangles of a skin with one texture.
struct SkinPart {
  const Image* texture = nullptr;  ///< One of the paint's; null: there is none.
  Eigen::Index first = 0, count = 0;
};

/// A shaded mesh whose triangles have a colour each, or a texture.
struct PaintedSkin {
  ShadedMesh skin;
  /// Colour of each vertex, RGB 0 … 1; equal at a triangle's corners. It multiplies a texture.
  Eigen::Matrix3Xf colors;
  Eigen::Matrix2Xf coordinates;  ///< Texture coordinates of each vertex; empty without textures.
  std::vector<SkinPart> parts;   ///< All triangles; empty without textures.
};

/// Gives each triangle the colour or texture that the paint has nearest to its middle. A vertex
/// between colours or at a seam appears once for each. Where a texture does not fit the triangle
/// (texture_fit.h) its mean over the paint's triangle takes its place.
/// @param own   Colour where the paint has none.
PaintedSkin painted_skin(const ShadedMesh& skin, const Paint& paint, const Eigen::Vector3f& own);

/// Returns a paint with the mean colours of its textures alone.
Paint without_textures(const Paint& paint);

}  // namespace render
