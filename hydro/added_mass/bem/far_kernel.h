#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "hydro/added_mass/bem/lanes.h"
#include "hydro/added_mass/bem/pair.h"

/// @file
/// Integrals of one element against eight others at a time: 1/r by quadrature points for distant
/// pairs, and the contributions of any pair to the equations. The code is compiled for each width
/// of vector registers; every lane is computed separately and in one order, so the results are the
/// same for all widths.

namespace hydro::bem {

/// Eight elements; the last batch is padded with copies. The first index is the point or corner,
/// the second the axis.
struct alignas(kAligned) Batch {
  Lanes points_3[3][3];  ///< Points of the rule of degree 2.
  Lanes points_6[6][3];  ///< Points of the rule of degree 4.
  Lanes corners[3][3], curls[3][3];
  Lanes normal[3], centroid[3];
  Lanes area, radius;
};
std::vector<Batch> batches_of(const std::vector<Element>& elements);

/// PairIntegrals for x on one element and y on the elements of a batch.
struct alignas(kAligned) LanePairs {
  Lanes hats[3][3];
  Lanes rise[3];
};

/// Integrates the pairs farther apart than kFar (pair.h) by 3 × 3 points, the others by 6 × 6.
void pairs_by_points(const Element& a, const Batch& b, LanePairs& pairs);

/// Replaces one lane by a pair that was integrated in another way.
void set_lane(const PairIntegrals& exact, std::size_t lane, LanePairs& pairs);
Eigen::Matrix3d hats_of_lane(const LanePairs& pairs, std::size_t lane);

/// ∫∫ curl φ_k·curl φ_l / r for the functions of galerkin.h on a and on the elements of a batch.
struct alignas(kAligned) LaneCouplings {
  Lanes functions[6][6];
};
void couple(const Element& a, const Batch& b, const LanePairs& pairs, LaneCouplings& couplings);

/// For each hat i of an element, ∫∫ λ_i(x) y nᵀ/r row by row, then ∫∫ λ_i(x) (n·x)/r, with y and n
/// on the other elements, summed over batches.
struct alignas(kAligned) LaneRotationMoments {
  Lanes hats[3][10];
};
void add_rotation_moments(const Batch& b, const LanePairs& pairs, LaneRotationMoments& moments);

/// For each hat i of an element T, the matrix for which ∫_T λ_i a dS = matrix · e / 4π in a
/// rotation about e: Σ_T' [(∫∫ λ_i y/r) n'ᵀ − ∫∫ λ_i (n'·x)/r], with x on T and y on T'
/// (galerkin.h).
using RotationMoments = std::array<Eigen::Matrix3d, 3>;
RotationMoments summed(const LaneRotationMoments& moments);

}  // namespace hydro::bem
