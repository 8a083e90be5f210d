#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "hydro/loads/loads.h"

/// @file
/// Loads of the contract by an independent method: polygon clipping in extended precision and Gauss
/// quadrature of the integrands as the contract states them.

namespace support {

using Vector3l = Eigen::Matrix<long double, 3, 1>;
using Polygon = std::vector<Vector3l>;

/// Returns the largest absolute component of force [N] and moment [N m].
inline double largest(const hydro::Wrench& w) {
  return std::max(w.force.cwiseAbs().maxCoeff(), w.moment.cwiseAbs().maxCoeff());
}

/// Returns the part of a convex polygon where a function linear in space is positive.
Polygon clip(const Polygon& polygon, const std::function<long double(const Vector3l&)>& f);

/// Returns ∫ f dA over a convex polygon by a fan of triangles, each cut into `splits`² cells with a
/// product of two six-point Gauss rules: exact for polynomials up to degree 10.
Vector3l integrate(const Polygon& polygon, const std::function<Vector3l(const Vector3l&)>& f,
                   int splits = 1);

/// Returns the loads on a mesh in a sea with the surface z = level. Faces are cut where depth and
/// v·n change sign; viscous drag uses `viscous_splits`, 0 for none.
hydro::Loads reference_loads(const hydro::TriMesh& mesh_B, const hydro::BodyState& state,
                             const hydro::Sea& sea, const hydro::Coefficients& coefficients,
                             int viscous_splits = 8);

}  // namespace support
