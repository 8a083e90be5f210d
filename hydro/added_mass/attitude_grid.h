#pragma once

#include <Eigen/Core>
#include <array>

/// @file
/// A grid over the directions in which the vertical may stand in a body, for interpolation.
///
/// The nodes lie on the octahedron |i| + |j| + |k| = m, which contains the six axes. A direction u
/// is brought onto it by i = m·asin|u_x| / Σ asin|u|, and so on, with the signs of u: along the
/// edges the nodes are then 90°/m apart, and about as much inside the faces. Three nodes surround
/// a direction; it has their barycentric weights, so the interpolation is continuous.

namespace hydro {

class AttitudeGrid {
 public:
  struct Corner {
    int node;
    double weight;
  };

  explicit AttitudeGrid(int divisions) : divisions_(divisions) {}

  /// Nodes are numbered below this; not every number is a node.
  int bound() const { return 2 * (2 * divisions_ + 1) * (2 * divisions_ + 1); }

  /// Unit.
  Eigen::Vector3d direction(int node) const;

  /// The nodes around a unit direction, with weights >= 0 of sum 1. Weights below 1e-4 are given to
  /// the others: a body that stands upright but for round-off or tiny motions has one node.
  std::array<Corner, 3> around(const Eigen::Vector3d& up) const;

 private:
  int number(const Eigen::Vector3i& place) const;

  int divisions_;
};

}  // namespace hydro
