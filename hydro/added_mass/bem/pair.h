#pragma once

#include "hydro/added_mass/bem/element.h"

/// @file
/// Integrals of 1/r over pairs of triangles, r = |x − y| with x on the first and y on the second,
/// against the hat functions of both.
///
/// By what the two have to do with each other:
/// - the same: closed form inside, graded points outside, scaled to the closed form of ∫∫ 1/r;
/// - a common edge or corner: closed form inside, 36 graded points outside;
/// - nearer than kNear: closed form inside, 7 points outside on pieces no larger than their
///   distance;
/// - nearer than kFar: 6 × 6 points, exact to degree 4 on each;
/// - farther: 3 × 3 points, exact to degree 2 on each.
///
/// Distances are those of the centroids over the sum of both radii. pair_integrals() takes the
/// first three, far_kernel.h the others.

namespace hydro::bem {

// No simple fractions, which regular meshes meet: which rule holds must not hang on round-off.
inline constexpr double kNear = 1.5137;
/// Beyond it 3 × 3 points err by no more than 6 × 6 points do beyond kNear: by 1.2e-4 of ∫∫ 1/r,
/// against 2.0e-4, in ∫∫ 1/r itself, and by 0.9e-4 in any ∫∫ λ_i λ_j/r. That is the most in 20,000
/// pairs of random triangles at the limit, half of them drawn out along the line between them,
/// which is the worst for a rule; the mean is 3e-5, against 1e-5.
inline constexpr double kFar = 4.0271;

/// Bound of the error of both rules, over ∫∫ 1/r.
inline constexpr double kFarError = 2.5e-4;

struct PairIntegrals {
  Eigen::Matrix3d hats = Eigen::Matrix3d::Zero();  ///< ∫∫ λ_i(x) λ_j(y)/r [m^3].
  /// ∫∫ λ_i(x) (n·x)/r with the second's normal n, and ∫∫ λ_j(y) (n·y)/r with the first's [m^4].
  Eigen::Vector3d rise = Eigen::Vector3d::Zero();
  Eigen::Vector3d other_rise = Eigen::Vector3d::Zero();

  double single() const { return hats.sum(); }  ///< ∫∫ 1/r [m^3].
};

/// The pair the other way round.
inline PairIntegrals turned(const PairIntegrals& pair) {
  return {pair.hats.transpose(), pair.other_rise, pair.rise};
}

/// Those with points on `a` and closed form over `b`.
/// @param shared   Corners they have in common, as vertices of a mesh: shared[i] is the corner of
///                 `b` that corner i of `a` is, or −1.
PairIntegrals integrals_from(const Element& a, const Element& b, const std::array<int, 3>& shared);

/// With points on the smaller of the two, which takes fewer pieces, and from both sides if they are
/// of one size: on a symmetric mesh a pair and its mirror image have the same integrals.
PairIntegrals pair_integrals(const Element& a, const Element& b, const std::array<int, 3>& shared);

/// True if the centroids are farther apart than `reach` times the sum of the radii.
inline bool is_beyond(double reach, const Element& a, const Element& b) {
  const double limit = reach * (a.radius + b.radius);
  return (a.centroid - b.centroid).squaredNorm() > limit * limit;
}

}  // namespace hydro::bem
