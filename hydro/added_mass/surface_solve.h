#pragma once

#include "hydro/added_mass/surface_patches.h"

/// @file
/// Added mass under a free surface in the limit of high frequency: no waves form, and the potential
/// is zero on the plane of the surface.
///
/// With ψ as in added_mass.h, ∂ψ/∂n = −N_m on the wetted part S_w, and G = 1/r − 1/r' with r' the
/// distance from the mirror image in the surface, which makes ψ zero there,
///
///     ½ψ(x) + (1/4π) ∫_{S_w} ψ n·∇(1/r' − 1/r) dS = (1/4π) ∫_{S_w} N (1/r − 1/r') dS     (1)
///     A_mn = ρ ∫_{S_w} ψ_m N_n dS                                                         (2)
///
/// with ∇ acting on the point y of the surface. ψ is linear on each patch, and (1) holds on each
/// patch in the mean, weighted by the same three functions. Near integrals are closed forms;
/// patches farther away than kFar radii act by their first two moments.

namespace hydro {

struct SurfaceSolution {
  Matrix6d matrix = Matrix6d::Zero();  ///< A for ρ = 1, B axes about its origin; symmetric, >= 0.
  /// Largest |A_mn − A_nm| before symmetrisation, relative to the largest A_mm of translation [-];
  /// the lever of moments is the root of the wetted area.
  double symmetry_error = 0;
  int unknowns = 0;
};

/// Number of patches for which README.md states the accuracy.
constexpr int kSurfacePatches = 250;

/// @param mesh_B   Closed. An empty or dry mesh has zero added mass.
SurfaceSolution solve_under(const TriMesh& mesh_B, const WaterPlane& plane,
                            int patches = kSurfacePatches);

}  // namespace hydro
