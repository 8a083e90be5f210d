#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

/// @file
/// Functions of two variables by polynomials through their values at Chebyshev's points.

namespace hydro {

struct ChebyshevInterval {
  double low, high;
  /// The variable of the polynomials, from −1 to 1.
  double inner(double t) const { return (2 * t - low - high) / (high - low); }
  double outer(double s) const { return (low + high + s * (high - low)) / 2; }
  double scale() const { return 2 / (high - low); }
};

/// A function on a rectangle as a sum of products of `Order` Chebyshev polynomials in each
/// variable.
template <int Order>
class ChebyshevTable {
 public:
  using Samples = Eigen::Matrix<double, Order, Order>;

  /// The function and its slopes.
  struct Sample {
    double value, by_first, by_second;
  };

  /// Place i of the samples along an interval.
  static double place(const ChebyshevInterval& interval, int i) {
    return interval.outer(std::cos(std::numbers::pi * (i + 0.5) / Order));
  }

  /// @param samples   Values at the places along the first variable (rows) and the second.
  ChebyshevTable(ChebyshevInterval first, ChebyshevInterval second, const Samples& samples)
      : first_(first), second_(second) {
    Samples transform;
    for (int i = 0; i < Order; ++i)
      for (int j = 0; j < Order; ++j)
        transform(i, j) =
            std::cos(std::numbers::pi * i * (j + 0.5) / Order) * (i == 0 ? 1.0 : 2.0) / Order;
    coefficients_ = transform * samples * transform.transpose();
  }

  Sample at(double first, double second) const {
    const Polynomials one = polynomials(first_.inner(first));
    const Polynomials two = polynomials(second_.inner(second));
    Polynomials along = Polynomials::Zero();
    for (int j = 0; j < Order; ++j) along.col(0) += two(j, 0) * coefficients_.col(j);
    for (int j = 0; j < Order; ++j) along.col(1) += two(j, 1) * coefficients_.col(j);
    const auto value = one.col(0), slope = one.col(1);
    return {value.dot(along.col(0)), first_.scale() * slope.dot(along.col(0)),
            second_.scale() * value.dot(along.col(1))};
  }

 private:
  /// The values of all polynomials at a place, and their slopes.
  using Polynomials = Eigen::Matrix<double, Order, 2>;

  static Polynomials polynomials(double s) {
    Polynomials v;
    v.row(0) << 1, 0;
    v.row(1) << s, 1;
    for (int i = 2; i < Order; ++i) {
      v(i, 0) = 2 * s * v(i - 1, 0) - v(i - 2, 0);
      v(i, 1) = 2 * v(i - 1, 0) + 2 * s * v(i - 1, 1) - v(i - 2, 1);
    }
    return v;
  }

  ChebyshevInterval first_, second_;
  Samples coefficients_;
};

}  // namespace hydro
