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
  inverse_diagonal_ = lower_.diagonal().cwiseInverse();
  positive_definite_ = factor.info() == Eigen::Success;
}

// Eigen's solutions divide by the diagonal each time, and those of several right-hand sides work by
// blocks in memory of their own.
Vector6d Cholesky6::solve(const Vector6d& x) const { return solve_upper(solve_lower(x)); }

Vector6d Cholesky6::solve_lower(Vector6d x) const {
  assert(positive_definite_);
  for (int j = 0; j < 6; ++j) {
    x[j] *= inverse_diagonal_[j];
    for (int i = j + 1; i < 6; ++i) x[i] -= lower_(i, j) * x[j];
  }
  return x;
}

Vector6d Cholesky6::solve_upper(Vector6d x) const {
  assert(positive_definite_);
  for (int j = 5; j >= 0; --j) {
    for (int i = j + 1; i < 6; ++i) x[j] -= lower_(i, j) * x[i];
    x[j] *= inverse_diagonal_[j];
  }
  return x;
}

Matrix6d Cholesky6::times_inverse_transpose(Matrix6d X) const {
  assert(positive_definite_);
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < i; ++k) X.col(i) -= lower_(i, k) * X.col(k);
    X.col(i) *= inverse_diagonal_[i];
  }
  return X;
}

Matrix6d Cholesky6::inverse() const {
  const Matrix6d upper = times_inverse_transpose(Matrix6d::Identity());
  return upper * upper.transpose();
}

Matrix6d Cholesky6::relative(const Matrix6d& X) const {
  const Matrix6d half = times_inverse_transpose(X);
  const Matrix6d both = times_inverse_transpose(half.transpose());
  return (both + both.transpose()) / 2;
}

}  // namespace hydro
