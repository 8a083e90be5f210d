#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "hydro/added_mass/bem/element.h"

/// @file
/// Elements in clusters of clusters, and which pairs of clusters are distant.

namespace hydro::bem {

struct Cluster {
  int first = 0, last = 0;  ///< Its elements: order[first … last).
  std::array<int, 2> children = {-1, -1};
  int parent = -1;
  Eigen::AlignedBox3d box;  ///< Of its elements' corners [m].
  std::vector<int> far;     ///< Distant clusters, whose parents are not all distant.
  std::vector<int> near;    ///< Of a leaf: the leaves left over, itself among them.

  bool is_leaf() const { return children[0] < 0; }
};

struct ClusterTree {
  std::vector<int> order;                        ///< Elements.
  std::vector<Cluster> clusters;                 ///< Parents before their children.
  std::vector<std::vector<std::size_t>> levels;  ///< Clusters by their distance from the root.
};

/// Halves clusters along the longest side of their box until they have few elements.
ClusterTree make_cluster_tree(const std::vector<Element>& elements);

}  // namespace hydro::bem
