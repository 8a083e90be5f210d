#pragma once

#include <functional>
#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// A tree of boxes over the faces of a mesh, to find faces near each other or along a ray.

namespace hydro {

class FaceTree {
 public:
  /// Vertices must be finite. Keeps a reference to the mesh.
  explicit FaceTree(const TriMesh& mesh);

  int leaf_count() const { return static_cast<int>(leaves_.size()); }

  /// Visits the pairs of faces whose boxes touch, one of them in leaf `leaf` and the other there or
  /// in a later leaf: over all leaves, each pair once. Stops after most_pairs().
  void visit_pairs(int leaf, const std::function<void(int, int)>& visit) const;

  /// Pairs looked at for one leaf: 5e7 over all leaves, but 256 at least. An even mesh has some 50
  /// a leaf; a fan of long slivers, whose boxes all touch, would have a number that grows with the
  /// square of its faces, and is looked at in part if it has more than 1e4.
  int most_pairs() const;

  /// Number of faces that a ray meets, among those for which `counts(face)` holds.
  int crossings(const Eigen::Vector3d& start, const Eigen::Vector3d& direction,
                const std::function<bool(int)>& counts) const;

 private:
  /// Covers the faces order_[first … last). Its left child follows it; a leaf has no right child.
  struct Node {
    Eigen::AlignedBox3d box;
    int first, last;
    int right = 0;
  };
  int build(int first, int last);
  bool visit_faces(const Node& leaf, const Node& other, int& budget,
                   const std::function<void(int, int)>& visit) const;

  const TriMesh& mesh_;
  std::vector<int> order_;                  ///< Faces along a space-filling curve.
  std::vector<Eigen::AlignedBox3d> boxes_;  ///< Of the faces, in that order [m].
  std::vector<Node> nodes_;
  std::vector<int> leaves_;  ///< Nodes, by `first`.
};

}  // namespace hydro
