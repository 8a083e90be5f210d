#pragma once

#include <Eigen/Core>
#include <vector>

#include "hydro/bem/element.h"

/// @file
/// The inner loop over distant pairs, compiled for each width of vector registers: operations on
/// single numbers only, in one order, so the results are the same for all of them.

// Sanitizers cannot follow the choice that the loader makes.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define PLIMSOLL_VECTOR_CLONES \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PLIMSOLL_VECTOR_CLONES
#endif

namespace hydro::bem {

/// The three points of the rule of degree 2 in every element, each coordinate by itself.
class FarPoints {
 public:
  explicit FarPoints(const std::vector<Element>& elements);
  std::size_t count() const { return count_; }
  /// Coordinate `axis` of point `k` in all elements.
  const double* row(std::size_t k, std::size_t axis) const {
    return coordinates_.data() + (3 * k + axis) * count_;
  }
  /// The three points of an element, a column each.
  Eigen::Matrix3d of(std::size_t element) const;

 private:
  std::size_t count_;
  std::vector<double> coordinates_;
};

/// For the points x_k of `element` and y_l of every element b: Σ_l 1/|x_k − y_l| in sums[k·F + b],
/// Σ_k 1/|x_k − y_l| in sums[(3 + l)·F + b]. Infinite where points coincide.
void far_sums(const FarPoints& points, std::size_t element, double* sums);

}  // namespace hydro::bem
