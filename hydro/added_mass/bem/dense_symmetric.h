#pragma once

#include <Eigen/Core>

/// @file
/// Algebra of large symmetric matrices that are stored densely: Cholesky's factor and products with
/// six vectors at once, on several threads, with sums in an order that does not depend on their
/// number.

namespace hydro::bem {

/// Six numbers for each unknown.
using SixColumns = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// A symmetric positive matrix, stored as its lower triangle, without its first unknowns x: what
/// [A Cᵀ; C B] [x; y] = [f; g] leaves for y is (B − C A⁻¹ Cᵀ) y = g − C A⁻¹ f.
class Eliminated {
 public:
  /// Overwrites A, the first `count` rows and columns, by its factor of Cholesky's.
  /// @throws std::invalid_argument if A is not positive.
  Eliminated(Eigen::MatrixXd lower_triangle, Eigen::Index count);

  SixColumns solve(const SixColumns& f) const;                   ///< A⁻¹ f.
  SixColumns forward(const SixColumns& x) const;                 ///< C x.
  SixColumns backward(const SixColumns& y) const;                ///< Cᵀ y.
  SixColumns apply(const SixColumns& y) const;                   ///< (B − C A⁻¹ Cᵀ) y.
  double remaining(Eigen::Index i, Eigen::Index j) const;        ///< B_ij.
  Eigen::Index count() const { return count_; }                  ///< Size of x.
  Eigen::Index rest() const { return matrix_.rows() - count_; }  ///< Size of y.

 private:
  Eigen::MatrixXd matrix_;
  Eigen::Index count_;
};

}  // namespace hydro::bem
