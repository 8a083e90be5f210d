#pragma once

#include <functional>
#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// A bounding-box tree over the faces of a mesh; it finds faces near each other, near a point or
/// along a ray.

namespace hydro {

/// Returns the faces in the order of a space-filling curve through the centres of their boxes: runs
/// of them are near each other. The vertices must be finite.
std::vector<int> faces_along_curve(const TriMesh& mesh);

class FaceTree {
 public:
  /// The vertices must be finite. The tree keeps a reference to the mesh.
  explicit FaceTree(const TriMesh& mesh);

  int leaf_count() const { return static_cast<int>(leaves_.size()); }

  /// Visits the pairs of faces whose boxes touch, one face in leaf `leaf`, the other in the same or
  /// a later leaf. Calls for all leaves visit each pair once. A call stops after most_pairs()
  /// pairs.
  void visit_pairs(int leaf, const std::function<void(int, int)>& visit) const;

  /// Largest number of pairs visited for one leaf: 5e7 over the number of leaves, but at least 256.
  /// A mesh of even triangles has about 50 pairs per leaf. In a fan of long slivers all boxes touch
  /// and the number grows with the square of the faces; beyond 1e4 faces only a part is visited.
  int most_pairs() const;

  /// Returns the face nearest to a point, the first of equals in the tree's order; -1 without
  /// faces.
  int nearest(const Eigen::Vector3d& point) const;

  /// Number of faces that a ray intersects and for which `counts(face)` holds.
  int crossings(const Eigen::Vector3d& start, const Eigen::Vector3d& direction,
                const std::function<bool(int)>& counts) const;

  /// True for a point inside the mesh, which must be closed: most of three rays leave it through an
  /// odd number of faces. One ray may meet an edge.
  bool contains(const Eigen::Vector3d& point) const;

 private:
  /// A node covers the faces order_[first … last). Its left child follows it in nodes_; a leaf has
  /// right = 0.
  struct Node {
    Eigen::AlignedBox3d box;
    int first, last;
    int right = 0;
  };
  int build(int first, int last);
  bool visit_faces(const Node& leaf, const Node& other, int& budget,
                   const std::function<void(int, int)>& visit) const;

  const TriMesh& mesh_;
  std::vector<int> order_;                  ///< faces_along_curve
  std::vector<Eigen::AlignedBox3d> boxes_;  ///< Boxes of the faces in that order [m].
  std::vector<Node> nodes_;
  std::vector<int> leaves_;  ///< Indices of the leaf nodes, ascending in `first`.
};

}  // namespace hydro
