#include "hydro/decompositions.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

/// Decompositions and solutions, held against Eigen's.

namespace {

using hydro::Matrix6d;
using hydro::Vector6d;

constexpr double kRoundings = 1e-14;

class Decompositions : public testing::Test {
 protected:
  double number() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }
  Matrix6d any() {
    return Matrix6d::NullaryExpr([this] { return number(); });
  }
  Vector6d vector() {
    return Vector6d::NullaryExpr([this] { return number(); });
  }
  Matrix6d symmetric() {
    const Matrix6d X = any();
    return X + X.transpose();
  }
  /// A positive definite matrix in units that differ by many decades.
  Matrix6d inertia(double decades) {
    const Matrix6d X = any();
    const Vector6d scale = (decades * std::log(10.0) * vector()).array().exp();
    return scale.asDiagonal() * (X * X.transpose() + 0.1 * Matrix6d::Identity()) *
           scale.asDiagonal();
  }

  std::mt19937_64 engine_{5};
};

/// Expects matrix = V diag(values) Vᵀ with orthonormal V, and the values that Eigen finds.
void expect_decomposed(const Matrix6d& matrix) {
  const double size = std::max(matrix.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
  const auto [values, V] = hydro::eigen_decomposition(matrix);
  EXPECT_TRUE((V.transpose() * V).isApprox(Matrix6d::Identity(), kRoundings));
  const Matrix6d again = V * values.asDiagonal() * V.transpose();
  EXPECT_LT((again - matrix).cwiseAbs().maxCoeff() / size, kRoundings) << matrix;
  Vector6d ascending = values;
  std::sort(ascending.begin(), ascending.end());
  const Vector6d expected = Eigen::SelfAdjointEigenSolver<Matrix6d>(matrix).eigenvalues();
  EXPECT_LT((ascending - expected).cwiseAbs().maxCoeff() / size, kRoundings) << matrix;
  EXPECT_EQ(hydro::eigenvalues(matrix), ascending);
}

TEST_F(Decompositions, EigenvectorsAreThoseOfMatricesOfAllKinds) {
  for (int i = 0; i < 300; ++i) {
    expect_decomposed(symmetric());
    expect_decomposed(inertia(3));
    // Equal values on the diagonal turn by 45°; zeros and single values need no turn at all.
    Matrix6d level = symmetric();
    level.diagonal().setConstant(number());
    expect_decomposed(level);
    Matrix6d sparse = symmetric();
    sparse.row(i % 6).setZero();
    sparse.col(i % 6).setZero();
    expect_decomposed(sparse);
    const Vector6d v = vector();
    expect_decomposed(v * v.transpose());
  }
  expect_decomposed(Matrix6d::Zero());
  expect_decomposed(Matrix6d::Identity());
  expect_decomposed(Matrix6d::Ones());
}

template <int size>
void expect_small_decomposed(const Eigen::Matrix<double, size, size>& matrix) {
  const double largest = std::max(matrix.cwiseAbs().maxCoeff(), 1e-300);
  const auto [values, V] = hydro::eigen_decomposition(matrix);
  EXPECT_TRUE((V.transpose() * V).isIdentity(kRoundings));
  EXPECT_LT((V * values.asDiagonal() * V.transpose() - matrix).cwiseAbs().maxCoeff() / largest,
            kRoundings);
  const auto expected =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, size, size>>(matrix).eigenvalues();
  EXPECT_LT((values - expected).cwiseAbs().maxCoeff() / largest, kRoundings);  // ascending
  EXPECT_EQ(hydro::eigenvalues(matrix), values);
}

TEST_F(Decompositions, OfSmallMatricesAreInAscendingOrder) {
  for (int i = 0; i < 300; ++i) {
    const Matrix6d X = symmetric();
    expect_small_decomposed<3>(X.topLeftCorner<3, 3>());
    expect_small_decomposed<2>(X.topLeftCorner<2, 2>());
    expect_small_decomposed<3>(-X.topLeftCorner<3, 1>() * X.topLeftCorner<3, 1>().transpose());
  }
  expect_small_decomposed<3>(Eigen::Matrix3d::Zero());
  expect_small_decomposed<2>(Eigen::Matrix2d::Identity());
}

TEST_F(Decompositions, DenseSystemsAreSolved) {
  for (const int size : {1, 7, 90}) {
    const auto random = [this] { return number(); };
    const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(size, size, random);
    const Eigen::MatrixXd side = Eigen::MatrixXd::NullaryExpr(size, 3, random);
    Eigen::MatrixXd overwritten = A;
    EXPECT_TRUE((A * hydro::solve_dense(overwritten, side)).isApprox(side, 1e-9));
    const Eigen::MatrixXd S = A * A.transpose() + Eigen::MatrixXd::Identity(size, size);
    overwritten = S.triangularView<Eigen::Lower>();
    EXPECT_TRUE((S * hydro::solve_positive(overwritten, side.col(0))).isApprox(side.col(0), 1e-9));
  }
}

// The axis is perpendicular to both directions, and the angle that between them.
TEST_F(Decompositions, TheShortestTurnTakesOneDirectionToAnother) {
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d from = vector().head<3>(), any = vector().head<3>();
    const Eigen::Vector3d across = from.cross(any).normalized() * from.norm();
    for (const Eigen::Vector3d& to :
         {any, Eigen::Vector3d(2 * from), Eigen::Vector3d(-from),
          Eigen::Vector3d(-from + 1e-7 * across), Eigen::Vector3d(from + 1e-7 * across)}) {
      const Eigen::Quaterniond turn = hydro::shortest_turn(from, to);
      EXPECT_NEAR(turn.norm(), 1, kRoundings);
      // Near the opposite direction the round-off of the sum of both counts over its length.
      EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-8);
      EXPECT_NEAR(turn.vec().dot(from.normalized()), 0, 1e-8);
    }
  }
}

TEST_F(Decompositions, ElementsThatAreNegligibleCountAsZero) {
  Matrix6d matrix = 1e-12 * symmetric();
  matrix.diagonal() = vector();
  const auto [values, V] = hydro::eigen_decomposition(matrix, 1e-11);
  EXPECT_EQ(values, Vector6d(matrix.diagonal()));
  EXPECT_EQ(V, Matrix6d(Matrix6d::Identity()));
}

TEST_F(Decompositions, WhatIsNotANumberEndsToo) {
  Matrix6d matrix = symmetric();
  matrix(1, 4) = matrix(4, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(hydro::eigen_decomposition(matrix).values.allFinite());
}

TEST_F(Decompositions, TheFactorSolvesWhatItIsOf) {
  for (int i = 0; i < 300; ++i) {
    const Matrix6d S = inertia(2);
    const hydro::Cholesky6 factor(S);
    ASSERT_TRUE(factor.positive_definite());
    // Errors are measured in units in which the diagonal is 1.
    const Vector6d unit = S.diagonal().cwiseSqrt();
    const Vector6d x = unit.cwiseInverse().cwiseProduct(vector());
    const double condition = 1e3;
    EXPECT_LT(unit.cwiseProduct(factor.solve(S * x) - x).norm(), condition * kRoundings);
    EXPECT_LT(unit.cwiseProduct(factor.inverse() * (S * x) - x).norm(), condition * kRoundings);
    EXPECT_EQ(factor.inverse(), Matrix6d(factor.inverse().transpose()));
    const Matrix6d& L = factor.lower();
    EXPECT_TRUE(L.isLowerTriangular(0));
    EXPECT_TRUE((L * factor.solve_lower(unit)).isApprox(unit, kRoundings));
    EXPECT_TRUE((L.transpose() * factor.solve_upper(x)).isApprox(x, kRoundings));
    const Matrix6d X = unit.asDiagonal() * symmetric() * unit.asDiagonal();
    const Matrix6d relative = factor.relative(X);
    EXPECT_EQ(relative, Matrix6d(relative.transpose()));
    EXPECT_TRUE((L * relative * L.transpose()).isApprox(X, condition * kRoundings));
  }
}

TEST_F(Decompositions, AMatrixThatIsNotPositiveDefiniteIsNotFactorised) {
  Matrix6d matrix = Matrix6d::Identity();
  EXPECT_TRUE(hydro::Cholesky6(matrix).positive_definite());
  matrix(3, 3) = -1;
  EXPECT_FALSE(hydro::Cholesky6(matrix).positive_definite());
  EXPECT_FALSE(hydro::Cholesky6(Matrix6d::Zero()).positive_definite());
}

}  // namespace
