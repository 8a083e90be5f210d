#include "engine/added_inertia.h"

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

/// (1) in the one direction n.
InertiaChange change_along(const Vector6d& n, const Matrix6d& inertia, const Matrix6d& change,
                           const Vector6d& u) {
  const double mu = n.dot(change * n) / n.dot(inertia * n);
  return {.inertia = (1 + std::max(mu, mu / 2)) * inertia, .velocity = u / (1 + std::max(mu, 0.0))};
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
  if (freedom.along) return change_along(*freedom.along, inertia, change, u);
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
  if (freedom.along) {
    const Vector6d& n = *freedom.along;
    return n.dot(rhs) / n.dot(matrix * n) * n;
  }
  const DofMask& locked = freedom.locked;
  if (partly_held(locked)) matrix = uncoupled(matrix, locked, 1);
  for (int i = 0; i < 6; ++i)
    if (locked[static_cast<std::size_t>(i)]) rhs[i] = 0;
  return hydro::Cholesky6(matrix).solve(rhs);
}

}  // namespace engine
