#pragma once

#include <array>
#include <vector>

#include "hydro/added_mass/bem/cluster_tree.h"
#include "hydro/added_mass/bem/dense.h"
#include "hydro/added_mass/bem/far_kernel.h"
#include "hydro/added_mass/bem/interpolation.h"
#include "hydro/added_mass/bem/surface.h"

/// @file
/// The integrals of 1/r between all pairs of elements, without storing the pairs of distant
/// clusters: there 1/r is interpolated between Chebyshev points in both clusters' boxes, at most
/// kOrder per side, and moments and fields are passed up and down the tree. Near pairs are stored.
/// Time and memory grow as F log F with the number F of faces.

namespace hydro::bem {

/// Values of several quantities: one row per element or point, stored row by row.
using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class CompressedInteractions {
 public:
  explicit CompressedInteractions(const Surface& surface);

  /// Σ_T' q_T' ∫_T ∫_T' 1/r for several q, one row per element T.
  Columns apply(const Columns& densities) const;
  /// Σ_T' q_T' ∫_T λ_i ∫_T' 1/r for the hats λ_i of T, three rows per element. It takes as long as
  /// the constructor.
  Columns apply_to_hats(const Columns& densities) const;
  /// ∫_T ∫_T λ_i λ_j/r.
  const Eigen::Matrix3d& self(std::size_t element) const { return self_[element]; }
  const std::vector<RotationMoments>& rotation_moments() const { return rotation_moments_; }
  double bytes() const;

 private:
  /// Σ q/r over the points of distant clusters, at every point: three rows per element.
  Columns far_potentials(const Columns& charges) const;
  Columns charges_of(const Columns& densities) const;
  void make_batches();
  void store_near();
  void add_far_rotation_moments();
  /// Calls f(batch, pairs) for the batches near the element at position `place` of the tree's
  /// order.
  template <class Function>
  void for_near(std::size_t place, Function&& f) const;
  /// gather() forms a cluster's moments from its children's or its elements' charges; spread() adds
  /// its parent's field and evaluates it at the points of a leaf.
  void gather(const Columns& charges, std::size_t cluster, std::vector<Columns>& moments) const;
  void spread(std::size_t cluster, std::vector<Columns>& fields, Columns& potentials) const;
  Eigen::Vector3d point_of(std::size_t element, std::size_t k) const;
  /// Contribution of point k to ∫ λ_i dS.
  double hat_weight(std::size_t element, std::size_t k, std::size_t i) const;

  /// Up to eight elements of a leaf.
  struct LeafBatch {
    Batch batch;
    std::vector<std::size_t> elements;
  };

  const Surface& surface_;
  ClusterTree tree_;
  std::vector<Grid> grids_;             ///< Grids of the clusters.
  std::vector<int> leaf_of_;            ///< Leaf at each position of the tree's order.
  std::vector<LeafBatch> batches_;      ///< Batches, leaf by leaf.
  std::vector<std::size_t> batch_of_;   ///< First batch of each leaf, by cluster.
  std::vector<std::size_t> row_start_;  ///< Start of each element's near pairs.
  std::vector<int> near_;
  std::vector<double> single_;
  std::vector<Eigen::Matrix3d> self_;
  std::vector<RotationMoments> rotation_moments_;
};

}  // namespace hydro::bem
