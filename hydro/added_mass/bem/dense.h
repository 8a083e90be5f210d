#pragma once

#include <Eigen/Core>
#include <vector>

#include "hydro/added_mass/bem/far_kernel.h"
#include "hydro/added_mass/bem/surface.h"

/// @file
/// The equations of galerkin.h with every interaction stored.

namespace hydro::bem {

struct DenseEquations {
  Eigen::MatrixXd matrix;  ///< (1/4π) ∫∫ curl φ_k·curl φ_l / r [m]: its lower triangle.
  std::vector<RotationMoments> rotation_moments;  ///< One entry per element.
};

DenseEquations dense_equations(const Surface& surface);

}  // namespace hydro::bem
