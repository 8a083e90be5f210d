#pragma once

#include <Eigen/Core>
#include <memory>

#include "app/render/interior_look.h"
#include "app/render/texture_map.h"
#include "hydro/loads/coefficients.h"
#include "hydro/mesh/mesh.h"

namespace render {

/// The colours of a surface, such as those of the materials of a mesh file. A body's face has the
/// colour of the nearest triangle of the surface.
struct Paint {
  hydro::TriMesh surface_B;
  Eigen::Matrix3Xf colors;  ///< Colour of each triangle, RGB 0 … 1; negative: none.
  /// Images over the triangles, of which `colors` has the means; null: there are none.
  std::shared_ptr<const TextureMap> textures = {};
};

/// Look of a body, constant over a sequence.
struct BodyAppearance {
  hydro::TriMesh mesh_B;
  Eigen::Vector3d color = {0.72, 0.73, 0.75};  ///< Colour of the dry surface, RGB 0 … 1.
  std::shared_ptr<const Paint> paint = {};     ///< Over that colour; null: there is none.
  hydro::Coefficients coefficients;            ///< Coefficients of the dynamic pressure.
  Hollows hollows = Hollows::none;
  Eigen::Vector3d up_B = Eigen::Vector3d::UnitZ();  ///< The vertical for `Hollows::dry`.
};

}  // namespace render
