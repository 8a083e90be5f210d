#pragma once

#include <Eigen/Core>

#include "app/render/interior_look.h"
#include "hydro/loads/coefficients.h"
#include "hydro/mesh/mesh.h"

namespace render {

/// Look of a body, constant over a sequence.
struct BodyAppearance {
  hydro::TriMesh mesh_B;
  Eigen::Vector3d color = {0.72, 0.73, 0.75};  ///< Colour of the dry surface, RGB 0 … 1.
  hydro::Coefficients coefficients;            ///< Coefficients of the dynamic pressure.
  Hollows hollows = Hollows::none;
  Eigen::Vector3d up_B = Eigen::Vector3d::UnitZ();  ///< The vertical for `Hollows::dry`.
};

}  // namespace render
