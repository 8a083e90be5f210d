#pragma once

#include <Eigen/Geometry>
#include <array>

/// @file
/// Interpolation between Chebyshev points in a box.

namespace hydro::bem {

/// Number of Chebyshev points along the longest side of a cluster; it sets the accuracy of
/// compressed interactions. With 4 the added mass differs from that of stored interactions by 1e-4
/// of its largest element, with 3 by 6e-4.
inline constexpr int kOrder = 4;

/// Number of columns processed at a time, a whole vector register.
inline constexpr int kBlock = 8;

/// Interactions are summed in single precision: its relative error is 1e-7, that of interpolation
/// 1e-4.
using FloatColumns = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Chebyshev points in a box: kOrder along its longest side, along the others as many as give the
/// same error.
class Grid {
 public:
  explicit Grid(const Eigen::AlignedBox3d& box);
  Eigen::Index count() const { return nodes_.rows(); }
  const Eigen::MatrixX3d& nodes() const { return nodes_; }  ///< One row per node [m].
  /// Interpolation weights of the nodes at a point of the box.
  Eigen::VectorXd weights_at(const Eigen::Vector3d& x) const;
  const Eigen::Vector3d& center() const { return center_; }
  /// Offsets of the nodes from the center, padded to whole blocks with copies of the last.
  const Eigen::MatrixX3f& offsets() const { return offsets_; }

 private:
  Eigen::Vector3d center_, half_;
  std::array<int, 3> orders_;
  Eigen::MatrixX3d nodes_;
  Eigen::MatrixX3f offsets_;
};

/// field_i += Σ_j moment_j / |x_i − y_j| for the nodes of two grids.
/// @param moments   Its rows, like those of `field`, hold a multiple of kBlock numbers.
void add_interaction(const Grid& at, const Grid& from, const FloatColumns& moments, double* field);

}  // namespace hydro::bem
