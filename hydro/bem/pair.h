#pragma once

#include "hydro/bem/element.h"

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
inline constexpr double kFar = 4.0271;

/// Largest error of an integral from the rules for distant pairs, at their nearest, over ∫∫ 1/r.
inline constexpr double kFarError = 5e-4;

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

/// @param shared   Corners they have in common, as vertices of a mesh: shared[i] is the corner of
///                 `b` that corner i of `a` is, or −1.
PairIntegrals pair_integrals(const Element& a, const Element& b, const std::array<int, 3>& shared);

/// True if the centroids are farther apart than `reach` times the sum of the radii.
inline bool is_beyond(double reach, const Element& a, const Element& b) {
  const double limit = reach * (a.radius + b.radius);
  return (a.centroid - b.centroid).squaredNorm() > limit * limit;
}

}  // namespace hydro::bem
