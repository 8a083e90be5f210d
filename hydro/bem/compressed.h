#pragma once

#include <array>
#include <vector>

#include "hydro/bem/cluster_tree.h"
#include "hydro/bem/interpolation.h"

/// @file
/// The integrals of 1/r between all pairs of elements, without storing those of distant clusters:
/// there 1/r is interpolated between Chebyshev points, kOrder a side at most, in either cluster's
/// box, and what clusters give and take is handed up and down their tree. Near pairs are stored.
/// Time and memory grow as F log F.

namespace hydro::bem {

/// Values of a few quantities at once: a row an element or a point, in memory row by row.
using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class CompressedInteractions {
 public:
  CompressedInteractions(const TriMesh& mesh, const std::vector<Element>& elements);

  /// Σ_T' q_T' ∫_T ∫_T' 1/r for several q: a row an element.
  Columns apply(const Columns& densities) const;
  /// ∫_T ∫_T 1/r.
  double self(std::size_t element) const { return self_[element]; }
  /// As in DenseInteractions.
  const std::vector<Eigen::Matrix3d>& swirl() const { return swirl_; }
  double bytes() const;

 private:
  /// Σ q/r over the points of distant clusters, at every point.
  Columns far_potentials(const Columns& charges) const;
  void store_near(const TriMesh& mesh);
  void add_far_swirl();
  /// Of one cluster, its children's done, or its parent's.
  void gather(const Columns& charges, std::size_t cluster, std::vector<Columns>& moments) const;
  void spread(std::size_t cluster, std::vector<Columns>& fields, Columns& potentials) const;
  Eigen::Vector3d point_of(std::size_t element, std::size_t k) const;

  const std::vector<Element>& elements_;
  ClusterTree tree_;
  std::vector<Grid> grids_;             ///< Of the clusters.
  std::vector<std::size_t> row_start_;  ///< Of the near pairs of elements in the tree's order.
  std::vector<int> near_;
  std::vector<double> single_;
  std::vector<double> self_;
  std::vector<Eigen::Matrix3d> swirl_;
};

}  // namespace hydro::bem
