#pragma once

#include "hydro/added_mass/bem/element.h"

/// @file
/// Integrals of 1/r over pairs of triangles, r = |x − y| with x on the first and y on the second,
/// against the hat functions of both.
///
/// The method depends on the position of the two; "inner" is the integral over one of them, "outer"
/// the integral over the other:
/// - identical: inner closed form, outer graded points, scaled to the closed form of ∫∫ 1/r;
/// - a common edge or corner: inner closed form, outer 36 graded points;
/// - nearer than kNear: inner closed form, outer 7 points on pieces no larger than their distance;
/// - nearer than kFar: 6 × 6 points, exact to degree 4 on each;
/// - farther: 3 × 3 points, exact to degree 2 on each.
///
/// Distances are between centroids, over the sum of both radii. pair_integrals() covers the first
/// three cases, far_kernel.h the others.

namespace hydro::bem {

// The limits are no simple fractions, which occur in regular meshes: the choice of a rule must not
// depend on round-off.
inline constexpr double kNear = 1.5137;
/// Beyond kFar the error of 3 × 3 points does not exceed that of 6 × 6 points beyond kNear: over ∫∫
/// 1/r it is at most 1.2e-4 (6 × 6 points: 2.0e-4) in ∫∫ 1/r itself and 0.9e-4 in any ∫∫ λ_i λ_j/r.
/// These are the maxima of 20,000 pairs of random triangles at the limit, half of them stretched
/// along the line between them, the worst case for a rule; the mean is 3e-5 (6 × 6 points: 1e-5).
inline constexpr double kFar = 4.0271;

/// Bound of the error of both rules, over ∫∫ 1/r.
inline constexpr double kFarError = 2.5e-4;

struct PairIntegrals {
  Eigen::Matrix3d hats = Eigen::Matrix3d::Zero();  ///< ∫∫ λ_i(x) λ_j(y)/r [m^3].
  /// ∫∫ λ_i(x) (n·x)/r with the second's normal n; ∫∫ λ_j(y) (n·y)/r with the first's [m^4].
  Eigen::Vector3d rise = Eigen::Vector3d::Zero();
  Eigen::Vector3d other_rise = Eigen::Vector3d::Zero();

  double single() const { return hats.sum(); }  ///< ∫∫ 1/r [m^3].
};

/// The pair with its triangles exchanged.
inline PairIntegrals turned(const PairIntegrals& pair) {
  return {pair.hats.transpose(), pair.other_rise, pair.rise};
}

/// Returns the integrals with points on `a` and the closed form over `b`.
/// @param shared   Common corners: shared[i] is the corner of `b` at the mesh vertex of corner i
///                 of `a`, or −1.
PairIntegrals integrals_from(const Element& a, const Element& b, const std::array<int, 3>& shared);

/// Returns the integrals with points on the smaller of the two, which takes fewer pieces. For equal
/// sizes it returns the mean of both choices, so that on a symmetric mesh a pair and its mirror
/// image have the same integrals.
PairIntegrals pair_integrals(const Element& a, const Element& b, const std::array<int, 3>& shared);

/// True if the centroids are farther apart than `reach` times the sum of the radii.
inline bool is_beyond(double reach, const Element& a, const Element& b) {
  const double limit = reach * (a.radius + b.radius);
  return (a.centroid - b.centroid).squaredNorm() > limit * limit;
}

}  // namespace hydro::bem
