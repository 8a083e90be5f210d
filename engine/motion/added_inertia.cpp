#include "engine/motion/added_inertia.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "engine/motion/locks.h"
#include "hydro/decompositions.h"

namespace engine {
namespace {

/// The matrix without coupling of locked degrees of freedom, which get this diagonal.
Matrix6d uncoupled(Matrix6d matrix, const DofMask& locked, double diagonal) {
  for (int i = 0; i < 6; ++i) {
    if (!locked[i]) continue;
    matrix.row(i).setZero();
    matrix.col(i).setZero();
    matrix(i, i) = diagonal;
  }
  return matrix;
}

/// The basis of (E4).
struct Split {
  Split(const Matrix6d& inertia, const Matrix6d& change) : S(inertia) {
    // Relative to S, which is a unit here, round-off leaves no more.
    constexpr double kRoundOff = 1e-15;
    const hydro::EigenDecomposition6 eigen =
        hydro::eigen_decomposition(S.relative(change), kRoundOff);
    mu = eigen.values;
    V = eigen.vectors;
    root = S.lower() * V;
  }
  /// The factors of the inertia in its directions.
  Vector6d factor() const { return 1 + mu.array().max(mu.array() / 2); }
  Matrix6d inertia() const { return root * factor().asDiagonal() * root.transpose(); }
  Vector6d velocity(const Vector6d& u) const {
    const Vector6d kept = (root.transpose() * u).array() / (1 + mu.array().max(0.0));
    return S.solve_upper(V * kept);
  }

  hydro::Cholesky6 S;
  Vector6d mu;
  Matrix6d V;     ///< Lᵀ x_i, with S = L Lᵀ.
  Matrix6d root;  ///< The momenta S x_i.
};

/// (E4) in the subspace N. The inertia of the result holds for u = N q' alone.
InertiaChange change_along(const Subspace& N, const Matrix6d& inertia, const Matrix6d& change,
                           const Vector6d& u) {
  // Columns of zeros, with a unit of inertia that does not change, make the matrix 6 × 6.
  Matrix6d padded = Matrix6d::Zero();
  padded.leftCols(N.cols()) = N;
  Matrix6d S = padded.transpose() * inertia * padded;
  S.diagonal().tail(6 - N.cols()).setOnes();
  const Split split(S, padded.transpose() * change * padded);
  const Matrix6d conjugate = inertia * padded * hydro::Cholesky6(S).inverse();
  const Matrix6d grown = split.inertia() - S;
  const Vector6d rates = split.velocity(conjugate.transpose() * u);
  return {.inertia = inertia + conjugate * grown * conjugate.transpose(),
          .velocity = padded * rates};
}

}  // namespace

Matrix6d rigid_inertia(const BodySpec& body) {
  Matrix6d inertia = Matrix6d::Zero();
  inertia.diagonal().head<3>().setConstant(body.mass);
  inertia.bottomRightCorner<3, 3>() = body.inertia_B;
  return inertia;
}

InertiaChange inertia_change(const Matrix6d& inertia, const Matrix6d& change,
                             const Mobility& mobility, const Vector6d& u) {
  if (change.isZero(0)) return {.inertia = inertia, .velocity = u};
  if (mobility.subspace) return change_along(*mobility.subspace, inertia, change, u);
  const DofMask& locked = mobility.locked;
  const Split split(uncoupled(inertia, locked, 1), uncoupled(change, locked, 0));
  InertiaChange result{.inertia = split.inertia(), .velocity = split.velocity(u)};
  for (int i = 0; i < 6; ++i)
    if (locked[i]) result.velocity[i] = u[i];
  return result;
}

Vector6d solve_free(Matrix6d matrix, Vector6d rhs, const Mobility& mobility) {
  if (mobility.subspace) {
    const Subspace& N = *mobility.subspace;
    if (N.cols() == 1) return N * (N.col(0).dot(rhs) / N.col(0).dot(matrix * N.col(0)));
    const Eigen::Matrix3d reduced = N.transpose() * matrix * N;
    return N * reduced.llt().solve(N.transpose() * rhs);
  }
  const DofMask& locked = mobility.locked;
  if (partly_locked(locked)) matrix = uncoupled(matrix, locked, 1);
  for (int i = 0; i < 6; ++i)
    if (locked[i]) rhs[i] = 0;
  return hydro::Cholesky6(matrix).solve(rhs);
}

Matrix6d mobility_matrix(const Matrix6d& S, const DofMask& locked) {
  Matrix6d unlocked = S;
  for (int i = 0; i < 6; ++i) {
    if (!locked[i]) continue;
    unlocked.row(i).setZero();
    unlocked.col(i).setZero();
    unlocked(i, i) = 1;
  }
  Matrix6d inverse = hydro::Cholesky6(unlocked).inverse();
  for (int i = 0; i < 6; ++i)
    if (locked[i]) inverse(i, i) = 0;
  return inverse;
}

}  // namespace engine
