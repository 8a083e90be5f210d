#pragma once

#include "hydro/spatial.h"

/// @file
/// Decompositions of small symmetric matrices, compiled once because Eigen's templates for them
/// dominate the compile time.

namespace hydro {

/// Eigenvalues of a symmetric matrix, ascending.
Eigen::Vector3d eigenvalues(const Eigen::Matrix3d& matrix);
Vector6d eigenvalues(const Matrix6d& matrix);

/// matrix = vectors · diag(values) · vectorsᵀ; vectors orthonormal columns, in no order.
struct EigenDecomposition6 {
  Vector6d values;
  Matrix6d vectors;
};
/// @param matrix       Symmetric.
/// @param negligible   Elements off the diagonal up to this size count as zero.
EigenDecomposition6 eigen_decomposition(const Matrix6d& matrix, double negligible = 0);

/// Cholesky factorisation L Lᵀ of a symmetric positive definite matrix, L lower triangular. Only
/// the lower half of the matrix is read.
class Cholesky6 {
 public:
  explicit Cholesky6(const Matrix6d& matrix);

  bool positive_definite() const { return positive_definite_; }
  /// L, with zeros above the diagonal.
  const Matrix6d& lower() const { return lower_; }
  /// (L Lᵀ)⁻¹ x
  Vector6d solve(const Vector6d& x) const;
  /// L⁻¹ x
  Vector6d solve_lower(Vector6d x) const;
  /// L⁻ᵀ x
  Vector6d solve_upper(Vector6d x) const;
  /// (L Lᵀ)⁻¹, symmetric: it costs more than one solution, less than four.
  Matrix6d inverse() const;
  /// L⁻¹ X L⁻ᵀ of a symmetric matrix: X in the metric of L Lᵀ.
  Matrix6d relative(const Matrix6d& X) const;

 private:
  /// X L⁻ᵀ
  Matrix6d times_inverse_transpose(Matrix6d X) const;

  Matrix6d lower_;
  Vector6d inverse_diagonal_;  ///< 1 / L_jj
  bool positive_definite_;
};

}  // namespace hydro
