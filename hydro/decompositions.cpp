#include "hydro/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace hydro {

Eigen::Vector3d eigenvalues(const Eigen::Matrix3d& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

Vector6d eigenvalues(const Matrix6d& matrix) {
  return Eigen::SelfAdjointEigenSolver<Matrix6d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

EigenDecomposition6 eigen_decomposition(const Matrix6d& matrix) {
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
  return lower_.triangularView<Eigen::Lower>().solve(x);
}

Vector6d Cholesky6::solve_upper(const Vector6d& x) const {
  return lower_.transpose().triangularView<Eigen::Upper>().solve(x);
}

Matrix6d Cholesky6::inverse() const {
  const Matrix6d half = lower_.triangularView<Eigen::Lower>().solve(Matrix6d::Identity());
  return half.transpose() * half;
}

Matrix6d Cholesky6::relative(const Matrix6d& X) const {
  const Matrix6d half = lower_.triangularView<Eigen::Lower>().solve(X);
  const Matrix6d both = lower_.triangularView<Eigen::Lower>().solve(Matrix6d(half.transpose()));
  return (both + both.transpose()) / 2;
}

}  // namespace hydro
