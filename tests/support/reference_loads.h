#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "hydro/loads/loads.h"

/// @file
/// The loads of the contract by other means than the program's: polygon clipping in extended
/// precision and Gauss quadrature of the integrands as they are written there.

namespace support {

using Vector3l = Eigen::Matrix<long double, 3, 1>;
using Polygon = std::vector<Vector3l>;

/// The largest component of the force or the moment, as numbers [N, N m].
inline double largest(const hydro::Wrench& w) {
  return std::max(w.force.cwiseAbs().maxCoeff(), w.moment.cwiseAbs().maxCoeff());
}

/// The part of a convex polygon where a function linear in space is positive.
Polygon clip(const Polygon& polygon, const std::function<long double(const Vector3l&)>& f);

/// ∫ f dA over a convex polygon by a fan of triangles, each cut in `splits`² cells with the product
/// of two Gauss rules of six points in each: exact for polynomials up to degree 10.
Vector3l integrate(const Polygon& polygon, const std::function<Vector3l(const Vector3l&)>& f,
                   int splits = 1);

/// Loads on a mesh in a sea whose surface is the plane z = level, cut where depth and v·n change
/// sign; viscous drag with `viscous_splits`.
hydro::Loads reference_loads(const hydro::TriMesh& mesh_B, const hydro::BodyState& state,
                             const hydro::Sea& sea, const hydro::Coefficients& coefficients,
                             int viscous_splits = 8);

}  // namespace support
