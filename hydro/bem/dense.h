#pragma once

#include <Eigen/Core>
#include <vector>

#include "hydro/bem/element.h"

/// @file
/// The integrals of 1/r between all pairs of elements, each one stored.

namespace hydro::bem {

struct DenseInteractions {
  Eigen::MatrixXd single;  ///< F×F, ∫∫ 1/r [m^3].
  /// Per element T a matrix that gives ∫_T a dS = matrix · e / 4π for a rotation about e:
  /// Σ_T' [(∫∫ y/r) n'ᵀ − n'·(∫∫ x/r)], with x on T and y on T' (galerkin.h).
  std::vector<Eigen::Matrix3d> swirl;
};

/// Corners that two faces have in common, as pair_integrals takes them.
std::array<int, 3> shared_corners(const Eigen::Matrix3Xi& faces, Eigen::Index a, Eigen::Index b);

/// What one element gives to another: x on `a`, y on `b`.
struct OrderedPair {
  double single;
  Eigen::Matrix3d swirl;  ///< Part of a's.
};

/// Any pair, by pair.h; `single` is the same both ways round.
OrderedPair near_pair(const TriMesh& mesh, const std::vector<Element>& elements, Eigen::Index a,
                      Eigen::Index b);

/// Near pairs by pair.h, far pairs by its 3 × 3 rule.
DenseInteractions dense_interactions(const TriMesh& mesh, const std::vector<Element>& elements);

}  // namespace hydro::bem
