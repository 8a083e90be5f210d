#pragma once

#include "hydro/spatial.h"

/// @file
/// Decompositions and solutions that are compiled once, because Eigen's templates for them dominate
/// the compile time.

namespace hydro {

/// Eigenvalues of a symmetric matrix, ascending.
Eigen::Vector2d eigenvalues(const Eigen::Matrix2d& matrix);
Eigen::Vector3d eigenvalues(const Eigen::Matrix3d& matrix);
Vector6d eigenvalues(const Matrix6d& matrix);

/// matrix = vectors · diag(values) · vectorsᵀ; vectors orthonormal columns, values ascending.
template <int size>
struct EigenDecomposition {
  Eigen::Matrix<double, size, 1> values;
  Eigen::Matrix<double, size, size> vectors;
};
/// @param matrix   Symmetric.
EigenDecomposition<2> eigen_decomposition(const Eigen::Matrix2d& matrix);
EigenDecomposition<3> eigen_decomposition(const Eigen::Matrix3d& matrix);

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

/// matrix⁻¹ side, by LU decomposition with pivots. @param matrix   Square; overwritten.
Eigen::MatrixXd solve_dense(Eigen::Ref<Eigen::MatrixXd> matrix, const Eigen::MatrixXd& side);

/// matrix⁻¹ side, by Cholesky's decomposition.
/// @param matrix   Symmetric, positive definite; only its lower half is read. Overwritten.
Eigen::VectorXd solve_positive(Eigen::Ref<Eigen::MatrixXd> matrix, const Eigen::VectorXd& side);

/// The rotation by the least angle that turns one direction into another. Lengths do not matter.
Eigen::Quaterniond shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace hydro
