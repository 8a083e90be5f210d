#include "engine/added_inertia.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "engine/locks.h"
#include "hydro/decompositions.h"

namespace engine {
namespace {

/// The matrix with locked degrees of freedom cut off from the others.
Matrix6d uncoupled(Matrix6d matrix, const DofMask& locked, double diagonal) {
  for (int i = 0; i < 6; ++i) {
    if (!locked[static_cast<std::size_t>(i)]) continue;
    matrix.row(i).setZero();
    matrix.col(i).setZero();
    matrix(i, i) = diagonal;
  }
  return matrix;
}

/// (1) in the ways N that are left: S of its result is that for u = N q', and in the rest as it
/// was.
InertiaChange change_along(const Ways& N, const Matrix6d& inertia, const Matrix6d& change,
                           const Vector6d& u) {
  using Reduced = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
  const Reduced S = N.transpose() * inertia * N;
  const Reduced D = N.transpose() * change * N;
  const Eigen::LLT<Reduced> root_S(S);
  const Reduced L = root_S.matrixL();
  const Reduced half = root_S.matrixL().solve(D);
  const Reduced relative = root_S.matrixL().solve(half.transpose().eval());
  const Eigen::SelfAdjointEigenSolver<Reduced> eigen(relative);
  const auto mu = eigen.eigenvalues().array();
  const Reduced root = L * eigen.eigenvectors();
  const Ways conjugate = inertia * N * root_S.solve(root);  // of unit energy, as momenta
  const auto grown = mu.max(mu / 2);
  InertiaChange result{.inertia = inertia};
  for (Eigen::Index k = 0; k < N.cols(); ++k)
    result.inertia += grown[k] * conjugate.col(k) * conjugate.col(k).transpose();
  const auto kept = (conjugate.transpose() * u).array() / (1 + mu.max(0.0));
  result.velocity = N * root_S.solve(root * kept.matrix());
  return result;
}

}  // namespace

Matrix6d rigid_inertia(const BodySpec& body) {
  Matrix6d inertia = Matrix6d::Zero();
  inertia.diagonal().head<3>().setConstant(body.mass);
  inertia.bottomRightCorner<3, 3>() = body.inertia_B;
  return inertia;
}

InertiaChange inertia_change(const Matrix6d& inertia, const Matrix6d& change,
                             const Freedom& freedom, const Vector6d& u) {
  if (change.isZero(0)) return {.inertia = inertia, .velocity = u};
  if (freedom.ways) return change_along(*freedom.ways, inertia, change, u);
  const DofMask& locked = freedom.locked;
  const hydro::Cholesky6 S(uncoupled(inertia, locked, 1));
  const auto [mu, V] = hydro::eigen_decomposition(S.relative(uncoupled(change, locked, 0)));
  const Matrix6d root = S.lower() * V;
  const Vector6d kept = (root.transpose() * u).array() / (1 + mu.array().max(0.0));
  const Vector6d factor = 1 + mu.array().max(mu.array() / 2);
  InertiaChange result{.inertia = root * factor.asDiagonal() * root.transpose(),
                       .velocity = S.solve_upper(V * kept)};
  for (int i = 0; i < 6; ++i)
    if (locked[static_cast<std::size_t>(i)]) result.velocity[i] = u[i];
  return result;
}

Vector6d solve_free(Matrix6d matrix, Vector6d rhs, const Freedom& freedom) {
  if (freedom.ways) {
    const Ways& N = *freedom.ways;
    if (N.cols() == 1) return N * (N.col(0).dot(rhs) / N.col(0).dot(matrix * N.col(0)));
    const Eigen::Matrix3d reduced = N.transpose() * matrix * N;
    return N * reduced.llt().solve(N.transpose() * rhs);
  }
  const DofMask& locked = freedom.locked;
  if (partly_held(locked)) matrix = uncoupled(matrix, locked, 1);
  for (int i = 0; i < 6; ++i)
    if (locked[static_cast<std::size_t>(i)]) rhs[i] = 0;
  return hydro::Cholesky6(matrix).solve(rhs);
}

}  // namespace engine
