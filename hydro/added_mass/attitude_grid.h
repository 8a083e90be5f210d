#pragma once

#include <Eigen/Core>
#include <array>

/// @file
/// An interpolation grid over the directions of the vertical in a body.
///
/// The nodes lie on the octahedron |i| + |j| + |k| = m, which contains the six axes. A direction u
/// maps onto it by i = m·asin|u_x| / Σ asin|u|, and likewise j and k, with the signs of u: nodes
/// are 90°/m apart along the edges and about as far inside the faces. A direction has the
/// barycentric weights of the three nodes around it, so the interpolation is continuous.

namespace hydro {

class AttitudeGrid {
 public:
  struct Corner {
    int node;
    double weight;
  };

  explicit AttitudeGrid(int divisions) : divisions_(divisions) {}

  /// Bound of the node numbers; not every number below it is a node.
  int bound() const { return 2 * (2 * divisions_ + 1) * (2 * divisions_ + 1); }

  /// Unit direction of a node.
  Eigen::Vector3d direction(int node) const;

  /// Returns the nodes around a unit direction, with weights >= 0 that sum to 1. Weights below 1e-4
  /// are shared among the others, so a body that is upright but for round-off or tiny motions has
  /// one node.
  std::array<Corner, 3> around(const Eigen::Vector3d& up) const;

 private:
  int number(const Eigen::Vector3i& place) const;

  int divisions_;
};

}  // namespace hydro
