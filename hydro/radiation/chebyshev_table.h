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
    const auto [value, slope] = polynomials(first_.inner(first));
    const auto [value2, slope2] = polynomials(second_.inner(second));
    const Values along = coefficients_ * value2;
    return {value.dot(along), first_.scale() * slope.dot(along),
            second_.scale() * value.dot(coefficients_ * slope2)};
  }

 private:
  using Values = Eigen::Matrix<double, Order, 1>;
  struct Polynomials {
    Values value, slope;
  };
  static Polynomials polynomials(double s) {
    Polynomials v;
    v.value[0] = 1;
    v.value[1] = s;
    v.slope[0] = 0;
    v.slope[1] = 1;
    for (int i = 2; i < Order; ++i) {
      v.value[i] = 2 * s * v.value[i - 1] - v.value[i - 2];
      v.slope[i] = 2 * v.value[i - 1] + 2 * s * v.slope[i - 1] - v.slope[i - 2];
    }
    return v;
  }

  ChebyshevInterval first_, second_;
  Samples coefficients_;
};

}  // namespace hydro
