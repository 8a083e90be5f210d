#pragma once

#include <Eigen/Geometry>
#include <array>

/// @file
/// Interpolation between Chebyshev points in a box.

namespace hydro::bem {

/// The accuracy of compressed interactions: Chebyshev points along the longest side of a cluster.
/// With 4 the added mass differs from that of stored interactions by 1e-4 of its largest element,
/// with 3 by 6e-4.
inline constexpr int kOrder = 4;

/// Columns are taken by this many at a time, a whole vector register or two.
inline constexpr int kBlock = 8;

/// A box with points in it: kOrder along its longest side, along the others as many as make the
/// same error.
class Grid {
 public:
  explicit Grid(const Eigen::AlignedBox3d& box);
  Eigen::Index count() const { return nodes_.rows(); }
  const Eigen::MatrixX3d& nodes() const { return nodes_; }  ///< A row a node [m].
  /// Their weights at a point of the box.
  Eigen::VectorXd weights_at(const Eigen::Vector3d& x) const;

 private:
  Eigen::Vector3d center_, half_;
  std::array<int, 3> orders_;
  Eigen::MatrixX3d nodes_;
};

/// field_i += Σ_j moment_j / |x_i − y_j| for the nodes of two grids.
/// @param moments, field   Rows of `columns` numbers, a multiple of kBlock.
void add_interaction(const Grid& at, const Grid& from, const double* moments, Eigen::Index columns,
                     double* field);

}  // namespace hydro::bem
