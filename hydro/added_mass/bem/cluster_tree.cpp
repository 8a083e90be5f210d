#include "hydro/added_mass/bem/cluster_tree.h"

#include <algorithm>

namespace hydro::bem {
namespace {

/// Largest number of elements in a leaf. A larger value stores more pairs one by one; a smaller one
/// makes more clusters.
constexpr int kLeaf = 40;

/// Clusters are distant if their centres are farther apart than this times the sum of their half
/// diagonals. A larger value makes their interpolation converge faster (compressed.h).
constexpr double kDistant = 1.6;

void split(const std::vector<Element>& elements, int index, std::size_t level, ClusterTree& tree) {
  if (tree.levels.size() == level) tree.levels.emplace_back();
  tree.levels[level].push_back(static_cast<std::size_t>(index));
  Cluster& cluster = tree.clusters[static_cast<std::size_t>(index)];
  const auto begin = tree.order.begin() + cluster.first;
  const auto end = tree.order.begin() + cluster.last;
  for (auto i = begin; i != end; ++i) {
    for (const Eigen::Vector3d& corner : elements[static_cast<std::size_t>(*i)].corners)
      cluster.box.extend(corner);
  }
  if (cluster.last - cluster.first <= kLeaf) return;
  Eigen::Index axis = 0;
  cluster.box.sizes().maxCoeff(&axis);
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [&](int a, int b) {
    const double at_a = elements[static_cast<std::size_t>(a)].centroid[axis];
    const double at_b = elements[static_cast<std::size_t>(b)].centroid[axis];
    return at_a < at_b || (at_a == at_b && a < b);
  });
  const int cut = static_cast<int>(middle - tree.order.begin());
  const std::array<std::array<int, 2>, 2> ranges = {std::array{cluster.first, cut},
                                                    std::array{cut, cluster.last}};
  for (std::size_t c = 0; c < 2; ++c) {
    const auto child = static_cast<int>(tree.clusters.size());
    tree.clusters[static_cast<std::size_t>(index)].children[c] = child;
    tree.clusters.push_back({.first = ranges[c][0], .last = ranges[c][1], .parent = index});
    split(elements, child, level + 1, tree);
  }
}

bool distant(const Cluster& a, const Cluster& b) {
  const double reach = kDistant * 0.5 * (a.box.sizes().norm() + b.box.sizes().norm());
  return (a.box.center() - b.box.center()).squaredNorm() > reach * reach;
}

/// Covers all pairs of elements of two clusters by far and near pairs of their subclusters.
void pair_up(ClusterTree& tree, int a, int b) {
  Cluster& left = tree.clusters[static_cast<std::size_t>(a)];
  Cluster& right = tree.clusters[static_cast<std::size_t>(b)];
  if (distant(left, right)) {
    left.far.push_back(b);
    if (a != b) right.far.push_back(a);
  } else if (left.is_leaf() && right.is_leaf()) {
    left.near.push_back(b);
    if (a != b) right.near.push_back(a);
  } else if (a == b) {
    const std::array<int, 2> children = left.children;
    pair_up(tree, children[0], children[0]);
    pair_up(tree, children[0], children[1]);
    pair_up(tree, children[1], children[1]);
  } else {
    const bool split_left =
        !left.is_leaf() && (right.is_leaf() || left.box.sizes().norm() >= right.box.sizes().norm());
    const std::array<int, 2> children = split_left ? left.children : right.children;
    for (const int child : children) pair_up(tree, child, split_left ? b : a);
  }
}

}  // namespace

ClusterTree make_cluster_tree(const std::vector<Element>& elements) {
  ClusterTree tree;
  for (std::size_t i = 0; i < elements.size(); ++i) tree.order.push_back(static_cast<int>(i));
  tree.clusters.push_back({.last = static_cast<int>(elements.size())});
  split(elements, 0, 0, tree);
  pair_up(tree, 0, 0);
  for (Cluster& cluster : tree.clusters) std::sort(cluster.near.begin(), cluster.near.end());
  return tree;
}

}  // namespace hydro::bem
