#pragma once

#include <array>
#include <vector>

#include "hydro/added_mass/bem/cluster_tree.h"
#include "hydro/added_mass/bem/dense.h"
#include "hydro/added_mass/bem/far_kernel.h"
#include "hydro/added_mass/bem/interpolation.h"
#include "hydro/added_mass/bem/surface.h"

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
  explicit CompressedInteractions(const Surface& surface);

  /// Σ_T' q_T' ∫_T ∫_T' 1/r for several q: a row an element.
  Columns apply(const Columns& densities) const;
  /// The same against each of T's hats, ∫_T λ_i: three rows an element. Takes as long as to
  /// construct this.
  Columns apply_to_hats(const Columns& densities) const;
  /// ∫_T ∫_T λ_i λ_j/r.
  const Eigen::Matrix3d& self(std::size_t element) const { return self_[element]; }
  const std::vector<Swirl>& swirl() const { return swirl_; }
  double bytes() const;

 private:
  /// Σ q/r over the points of distant clusters, at every point: three rows an element.
  Columns far_potentials(const Columns& charges) const;
  Columns charges_of(const Columns& densities) const;
  void make_batches();
  void store_near();
  void add_far_swirl();
  /// Calls f(batch, pairs) for the batches near the element at a place in the tree's order.
  template <class Function>
  void for_near(std::size_t place, Function&& f) const;
  /// Of one cluster, its children's done, or its parent's.
  void gather(const Columns& charges, std::size_t cluster, std::vector<Columns>& moments) const;
  void spread(std::size_t cluster, std::vector<Columns>& fields, Columns& potentials) const;
  Eigen::Vector3d point_of(std::size_t element, std::size_t k) const;
  /// Point k's part of ∫ λ_i dS.
  double hat_weight(std::size_t element, std::size_t k, std::size_t i) const;

  /// Up to eight elements of a leaf.
  struct LeafBatch {
    Batch batch;
    std::vector<std::size_t> elements;
  };

  const Surface& surface_;
  ClusterTree tree_;
  std::vector<Grid> grids_;             ///< Of the clusters.
  std::vector<int> leaf_of_;            ///< By place in the tree's order.
  std::vector<LeafBatch> batches_;      ///< Leaf by leaf.
  std::vector<std::size_t> batch_of_;   ///< The first of each cluster that is a leaf.
  std::vector<std::size_t> row_start_;  ///< Of the near pairs of elements in the tree's order.
  std::vector<int> near_;
  std::vector<double> single_;
  std::vector<Eigen::Matrix3d> self_;
  std::vector<Swirl> swirl_;
};

}  // namespace hydro::bem
