#pragma once

#include "hydro/bem/element.h"

/// @file
/// Integrals of 1/r over pairs of triangles, r = |x − y| with x on the first and y on the second.
///
/// | pair                              | rule                                                     |
/// | --------------------------------- | -------------------------------------------------------- |
/// | the same                          | ∫∫ 1/r in closed form, moments as for a common edge | | a
/// common edge or corner           | closed form inside, 36 graded points outside              | |
/// nearer than kNear radii           | closed form inside, 7 points outside on pieces that are   |
/// |                                   | no larger than their distance | | nearer than kFar radii
/// | 6 × 6 points, exact to degree 4 on each                   | | farther | 3 × 3 points, exact to
/// degree 2 on each: the multipole    | |                                   | expansion to second
/// order                                 |
///
/// Distances are those of the centroids over the sum of both radii. What the far rule leaves out
/// are moments of third order and above, at most kFarError of the integral.

namespace hydro::bem {

// No simple fractions, which regular meshes meet: which rule holds must not hang on round-off.
inline constexpr double kNear = 1.5137;
inline constexpr double kFar = 3.0271;

/// Largest relative error of ∫∫ 1/r from the two rules for distant pairs, at their nearest.
inline constexpr double kFarError = 5e-4;

struct PairIntegrals {
  double single = 0;                                 ///< ∫∫ 1/r [m^3].
  Eigen::Vector3d first = Eigen::Vector3d::Zero();   ///< ∫∫ x/r [m^4].
  Eigen::Vector3d second = Eigen::Vector3d::Zero();  ///< ∫∫ y/r [m^4].
};

/// The same for (a, b) and (b, a) but for which of the moments is first.
///
/// @param shared   Corners they have in common, as vertices of a mesh: shared[i] is the corner of
///                 `b` that corner i of `a` is, or −1.
PairIntegrals pair_integrals(const Element& a, const Element& b, const std::array<int, 3>& shared);

/// True if the far rule, 3 × 3 points, holds for the pair. It does not if they touch.
inline bool is_far(const Element& a, const Element& b) {
  const double reach = kFar * (a.radius + b.radius);
  return (a.centroid - b.centroid).squaredNorm() > reach * reach;
}

}  // namespace hydro::bem
