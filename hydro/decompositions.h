#pragma once

#include "hydro/spatial.h"

/// @file
/// Decompositions of small symmetric matrices, compiled once because Eigen's templates for them
/// dominate the compile time.

namespace hydro {

/// Eigenvalues of a symmetric matrix, ascending.
Eigen::Vector3d eigenvalues(const Eigen::Matrix3d& matrix);
Vector6d eigenvalues(const Matrix6d& matrix);

/// matrix = vectors · diag(values) · vectorsᵀ; values ascending, vectors orthonormal columns.
struct EigenDecomposition6 {
  Vector6d values;
  Matrix6d vectors;
};
EigenDecomposition6 eigen_decomposition(const Matrix6d& matrix);

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
  Vector6d solve_lower(const Vector6d& x) const;
  /// L⁻ᵀ x
  Vector6d solve_upper(const Vector6d& x) const;
  /// (L Lᵀ)⁻¹, symmetric: it costs more than one solution, less than four.
  Matrix6d inverse() const;
  /// L⁻¹ X L⁻ᵀ of a symmetric matrix: X in the metric of L Lᵀ.
  Matrix6d relative(const Matrix6d& X) const;

 private:
  Matrix6d solve_lower_by_columns(const Matrix6d& X) const;

  Matrix6d lower_;
  bool positive_definite_;
};

}  // namespace hydro
