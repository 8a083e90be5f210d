#pragma once

#include <stdexcept>

#include "hydro/added_mass/bem/galerkin.h"

/// @file
/// The method of conjugate gradients for all six motions at once.

namespace hydro::bem {

struct Iterated {
  Potential solution;
  int steps = 0;
};

/// Solves matrix · x = sides with a symmetric positive definite matrix, until the preconditioned
/// residual of each motion is at most `part` of its initial value. A motion that moves no water,
/// such as a sphere's roll, is measured against the others.
///
/// @param apply, precondition   Maps of Potentials: the matrix and an approximate inverse.
/// @throws std::invalid_argument if it does not converge.
template <class Apply, class Precondition>
Iterated conjugate_gradients(const Potential& sides, double part, Apply apply,
                             Precondition precondition) {
  constexpr int kMostSteps = 1000;
  const auto products = [](const Potential& a, const Potential& b) {
    return Vector6d(a.cwiseProduct(b).colwise().sum().transpose());
  };
  // The ratio is 0 for a motion that has converged exactly.
  const auto ratio = [](const Vector6d& a, const Vector6d& b) {
    return Vector6d((b.array() == 0).select(0, a.cwiseQuotient(b)));
  };
  Iterated result{Potential::Zero(sides.rows(), 6), 0};
  Potential residual = sides;
  Potential direction = precondition(residual);
  Vector6d size = products(residual, direction);
  const Vector6d goal = size.array().max(1e-12 * size.maxCoeff()) * part * part;
  // The condition is written so that a NaN does not pass for convergence.
  for (; !(size.array() <= goal.array()).all(); ++result.steps) {
    if (result.steps == kMostSteps || !size.allFinite())
      throw std::invalid_argument("the panels are too uneven to solve for the added mass");
    const Potential image = apply(direction);
    const Vector6d step = ratio(size, products(direction, image));
    result.solution += direction * step.asDiagonal();
    residual -= image * step.asDiagonal();
    const Potential next = precondition(residual);
    const Vector6d next_size = products(residual, next);
    direction = next + direction * ratio(next_size, size).asDiagonal();
    size = next_size;
  }
  return result;
}

}  // namespace hydro::bem
