#include "hydro/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

namespace hydro {
namespace {

/// Each pair of indices once. The pairs of a round have no index in common, so that no rotation
/// waits for another one.
constexpr int kRounds[5][3][2] = {{{0, 5}, {1, 4}, {2, 3}},
                                  {{0, 4}, {3, 5}, {1, 2}},
                                  {{0, 3}, {2, 4}, {1, 5}},
                                  {{0, 2}, {1, 3}, {4, 5}},
                                  {{0, 1}, {2, 5}, {3, 4}}};

/// The rotations of a round.
struct Rotations {
  /// The rotations after which the matrix has zeros between their indices.
  Rotations(const Matrix6d& matrix, const int (&round)[3][2], double negligible) : pairs(round) {
    for (int k = 0; k < 3; ++k) {
      const auto [p, q] = pairs[k];
      const double off = matrix(q, p), apart = matrix(q, q) - matrix(p, p);
      const bool turns = !(std::abs(off) <= negligible);  // NaN spreads.
      const double tangent = 2 * off / (std::abs(apart) + std::sqrt(apart * apart + 4 * off * off));
      const double t = turns ? std::copysign(1.0, apart) * tangent : 0;
      cosine[k] = 1 / std::sqrt(1 + t * t);
      sine[k] = t * cosine[k];
      any = any || turns;
    }
  }
  void turn_columns(Matrix6d& matrix) const {
    for (int k = 0; k < 3; ++k) {
      const auto [p, q] = pairs[k];
      if (sine[k] == 0) continue;
      const Vector6d first = matrix.col(p), second = matrix.col(q);
      matrix.col(p) = cosine[k] * first - sine[k] * second;
      matrix.col(q) = sine[k] * first + cosine[k] * second;
    }
  }

  const int (&pairs)[3][2];
  double cosine[3], sine[3];
  bool any = false;
};

constexpr int kMostSweeps = 30;

}  // namespace

// Jacobi's method takes half the time of Eigen's solver, which brings the matrix to three diagonals
// first, and less where elements are zero.
EigenDecomposition6 eigen_decomposition(const Matrix6d& matrix, double negligible) {
  assert(is_symmetric(matrix));
  Matrix6d left = matrix, vectors = Matrix6d::Identity();
  negligible = std::max(negligible, 1e-15 * matrix.cwiseAbs().maxCoeff());
  bool turned = true;
  for (int i = 0; i < kMostSweeps && turned; ++i) {
    turned = false;
    for (const auto& pairs : kRounds) {
      const Rotations rotations(left, pairs, negligible);
      if (!rotations.any) continue;
      turned = true;
      rotations.turn_columns(vectors);
      rotations.turn_columns(left);
      left = Matrix6d(left.transpose());
      rotations.turn_columns(left);
    }
  }
  return {left.diagonal(), vectors};
}

namespace {

/// By the same method, of a matrix with zeros around it: no rotation has anything to do with them.
template <int size>
EigenDecomposition<size> decomposition_of(const Eigen::Matrix<double, size, size>& matrix) {
  Matrix6d padded = Matrix6d::Zero();
  padded.topLeftCorner<size, size>() = matrix;
  const EigenDecomposition6 found = eigen_decomposition(padded);
  std::array<int, size> order;
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return found.values[a] < found.values[b]; });
  EigenDecomposition<size> sorted;
  for (int i = 0; i < size; ++i) {
    sorted.values[i] = found.values[order[static_cast<std::size_t>(i)]];
    sorted.vectors.col(i) =
        found.vectors.template block<size, 1>(0, order[static_cast<std::size_t>(i)]);
  }
  return sorted;
}

}  // namespace

EigenDecomposition<2> eigen_decomposition(const Eigen::Matrix2d& matrix) {
  return decomposition_of(matrix);
}

EigenDecomposition<3> eigen_decomposition(const Eigen::Matrix3d& matrix) {
  return decomposition_of(matrix);
}

Eigen::Vector2d eigenvalues(const Eigen::Matrix2d& matrix) {
  return decomposition_of(matrix).values;
}

Eigen::Vector3d eigenvalues(const Eigen::Matrix3d& matrix) {
  return decomposition_of(matrix).values;
}

Vector6d eigenvalues(const Matrix6d& matrix) { return decomposition_of(matrix).values; }

Eigen::MatrixXd solve_dense(Eigen::Ref<Eigen::MatrixXd> matrix, const Eigen::MatrixXd& side) {
  return Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>>(matrix).solve(side);
}

Eigen::VectorXd solve_positive(Eigen::Ref<Eigen::MatrixXd> matrix, const Eigen::VectorXd& side) {
  return Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(matrix).solve(side);
}

// Twice the half-way rotation. Eigen's takes the axis from a singular value decomposition.
Eigen::Quaterniond shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const Eigen::Vector3d axis = a.cross(b);
  const Eigen::Quaterniond turn(1 + a.dot(b), axis.x(), axis.y(), axis.z());
  if (turn.norm() > 1e-12) return turn.normalized();
  const Eigen::Vector3d across = a.unitOrthogonal();  // The directions are opposite.
  return {0, across.x(), across.y(), across.z()};
}

// Eigen's factorisation, written for matrices of any size, takes twice the time.
Cholesky6::Cholesky6(const Matrix6d& matrix) : lower_(Matrix6d::Zero()) {
#pragma GCC unroll 6
  for (int j = 0; j < 6; ++j) {
    const auto rest = [&](int i) {
      double sum = 0;
#pragma GCC unroll 6
      for (int k = 0; k < j; ++k) sum += lower_(i, k) * lower_(j, k);
      return matrix(i, j) - sum;
    };
    const double square = rest(j);
    positive_definite_ = !(square <= 0);  // NaN spreads.
    if (!positive_definite_) return;
    const double diagonal = lower_(j, j) = std::sqrt(square);
    inverse_diagonal_[j] = 1 / diagonal;
#pragma GCC unroll 6
    for (int i = j + 1; i < 6; ++i) lower_(i, j) = rest(i) / diagonal;
  }
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
