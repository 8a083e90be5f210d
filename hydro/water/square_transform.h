#pragma once

#include <Eigen/Core>
#include <vector>

/// @file
/// The Fourier transform of a square of numbers, in the widest vector registers that the processor
/// has. Lines of sixteen rows at a time are transformed along the columns by Stockham's algorithm
/// of radix 4, which needs no reordering, and written as columns; two such passes are the
/// transform. Sums are taken in one order, without fused operations, so that the results are the
/// same for all widths.

namespace hydro {

class SquareTransform {
 public:
  /// @param side   A power of two, 16 at least.
  explicit SquareTransform(Eigen::Index side);

  /// f̂(k) = Σ f e^{−ik·x} in place.
  /// @param other   Is overwritten.
  void forward(Eigen::MatrixXcf& field, Eigen::MatrixXcf& other) const;
  /// Its inverse in place: f = Σ f̂ e^{ik·x}/n².
  void inverse(Eigen::MatrixXcf& field, Eigen::MatrixXcf& other) const;

 private:
  Eigen::Index side_;
  std::vector<float> cosines_, sines_;  ///< e^{−2πi j/n}
};

}  // namespace hydro
