#pragma once

#include <Eigen/Core>
#include <vector>

#include "hydro/added_mass/bem/far_kernel.h"
#include "hydro/added_mass/bem/surface.h"

/// @file
/// The equations of galerkin.h with every interaction stored.

namespace hydro::bem {

struct DenseEquations {
  Eigen::MatrixXd matrix;    ///< (1/4π) ∫∫ curl φ_k·curl φ_l / r [m]: lower triangle.
  std::vector<Swirl> swirl;  ///< One per element.
};

DenseEquations dense_equations(const Surface& surface);

/// Six numbers for each unknown.
using SixColumns = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// A symmetric positive definite matrix, stored as its lower triangle, with its first unknowns x
/// eliminated: [A Cᵀ; C B] [x; y] = [f; g] becomes (B − C A⁻¹ Cᵀ) y = g − C A⁻¹ f.
class Eliminated {
 public:
  /// Overwrites A, the first `count` rows and columns, by its Cholesky factor.
  /// @throws std::invalid_argument if A is not positive definite.
  Eliminated(Eigen::MatrixXd lower_triangle, Eigen::Index count);

  SixColumns solve(const SixColumns& f) const;                   ///< A⁻¹ f.
  SixColumns forward(const SixColumns& x) const;                 ///< C x.
  SixColumns backward(const SixColumns& y) const;                ///< Cᵀ y.
  SixColumns apply(const SixColumns& y) const;                   ///< (B − C A⁻¹ Cᵀ) y.
  double remaining(Eigen::Index i, Eigen::Index j) const;        ///< B_ij.
  Eigen::Index count() const { return count_; }                  ///< Length of x.
  Eigen::Index rest() const { return matrix_.rows() - count_; }  ///< Length of y.

 private:
  Eigen::MatrixXd matrix_;
  Eigen::Index count_;
};

}  // namespace hydro::bem
