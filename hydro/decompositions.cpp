#include "hydro/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cassert>

namespace hydro {

Eigen::Vector3d eigenvalues(const Eigen::Matrix3d& matrix) {
  assert(is_symmetric(matrix));
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

Vector6d eigenvalues(const Matrix6d& matrix) {
  assert(is_symmetric(matrix));
  return Eigen::SelfAdjointEigenSolver<Matrix6d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

EigenDecomposition6 eigen_decomposition(const Matrix6d& matrix) {
  assert(is_symmetric(matrix));
  const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(matrix);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

Cholesky6::Cholesky6(const Matrix6d& matrix) {
  const Eigen::LLT<Matrix6d> factor(matrix);
  lower_ = factor.matrixL();
  positive_definite_ = factor.info() == Eigen::Success;
}

Vector6d Cholesky6::solve(const Vector6d& x) const { return solve_upper(solve_lower(x)); }

Vector6d Cholesky6::solve_lower(const Vector6d& x) const {
  assert(positive_definite_);
  return lower_.triangularView<Eigen::Lower>().solve(x);
}

Vector6d Cholesky6::solve_upper(const Vector6d& x) const {
  assert(positive_definite_);
  return lower_.transpose().triangularView<Eigen::Upper>().solve(x);
}

// Eigen unrolls the solution for a vector; for a matrix it allocates memory and works by blocks.
Matrix6d Cholesky6::solve_lower_by_columns(const Matrix6d& X) const {
  Matrix6d result;
  for (int i = 0; i < 6; ++i) result.col(i) = solve_lower(Vector6d(X.col(i)));
  return result;
}

Matrix6d Cholesky6::inverse() const {
  const Matrix6d half = solve_lower_by_columns(Matrix6d::Identity());
  return half.transpose() * half;
}

Matrix6d Cholesky6::relative(const Matrix6d& X) const {
  const Matrix6d half = solve_lower_by_columns(X);
  const Matrix6d both = solve_lower_by_columns(half.transpose());
  return (both + both.transpose()) / 2;
}

}  // namespace hydro
