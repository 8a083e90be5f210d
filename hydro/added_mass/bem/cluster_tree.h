#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "hydro/added_mass/bem/element.h"

/// @file
/// A tree of clusters of elements, with the pairs of clusters that are distant.

namespace hydro::bem {

struct Cluster {
  int first = 0, last = 0;  ///< The elements are order[first … last).
  std::array<int, 2> children = {-1, -1};
  int parent = -1;
  Eigen::AlignedBox3d box;  ///< Bounding box of the elements' corners [m].
  std::vector<int> far;     ///< Distant clusters in no distant pair of ancestors.
  std::vector<int> near;    ///< For a leaf: the leaves that are not distant, itself included.

  bool is_leaf() const { return children[0] < 0; }
};

struct ClusterTree {
  std::vector<int> order;                        ///< Element indices, cluster by cluster.
  std::vector<Cluster> clusters;                 ///< Parents precede their children.
  std::vector<std::vector<std::size_t>> levels;  ///< Clusters by their distance from the root.
};

/// Halves clusters along the longest side of their box until they have few elements.
ClusterTree make_cluster_tree(const std::vector<Element>& elements);

}  // namespace hydro::bem
