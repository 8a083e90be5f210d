#pragma once

#include <Eigen/Core>
#include <vector>

#include "hydro/bem/far_kernel.h"
#include "hydro/bem/surface.h"

/// @file
/// The equations of galerkin.h with every interaction stored.

namespace hydro::bem {

struct DenseEquations {
  Eigen::MatrixXd matrix;    ///< (1/4π) ∫∫ curl φ_k·curl φ_l / r [m].
  std::vector<Swirl> swirl;  ///< Of the elements.
};

DenseEquations dense_equations(const Surface& surface);

/// matrix · vectors for a symmetric matrix.
Eigen::Matrix<double, Eigen::Dynamic, 6> product(
    const Eigen::MatrixXd& matrix, const Eigen::Matrix<double, Eigen::Dynamic, 6>& vectors);

}  // namespace hydro::bem
