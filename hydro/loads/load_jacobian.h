#pragma once

#include "hydro/loads/loads.h"

/// @file
/// Derivatives of the loads on a hull with respect to its velocity and to its height and heel.
///
/// Pressure drag acts along the surface's normal: with b = (K n, r × n), K of bluntness.h, and the
/// velocity u about the centre of mass, its normal speed is b·u and
///
///     ∂F/∂u = −ρ ∫ C_p |b·u| b bᵀ dS,                                                        (1)
///
/// Friction acts along the tangential velocity: with the 3×6 matrix B of v = B u and t = v_t/|v_t|,
///
///     ∂F/∂u = −½ρ ∫ C_v |v_t| Bᵀ (1 − n nᵀ + t tᵀ) B dS,                                     (2)
///
/// where the change of C_v with speed is left out. Both are symmetric and negative semi-definite.
/// The change of displaced weight at the waterplane adds, with c = (0, 0, 1, y, −x, 0),
///
///     K = −ρ g ∫_waterplane c cᵀ dA = ρ g ∫_wet c cᵀ n_z dS                                  (3)
///
/// per displacement, by the divergence theorem for c cᵀ ẑ. The rotation of the buoyancy's own lever
/// is left out, so that K too is negative semi-definite. The integrals use the edge-midpoint rule,
/// whose weights are positive: it is exact for (3) in still water and of second order elsewhere.
///
/// The derivatives are about the centre of mass, in W axes. Lift is left out.

namespace hydro {

struct LoadJacobian {
  Matrix6d drag = Matrix6d::Zero();        ///< (1) + (2), and the air's [N s/m, N s, N m s].
  Matrix6d waterplane = Matrix6d::Zero();  ///< (3) [N/m, N, N m].
};

/// How far panels are split to follow waves: into pieces of a sixteenth of the body's radius, or as
/// far as those of the loads (refine.h). The first take half of the time, but may miss a crest that
/// is all of the water on a thin body.
enum class Pieces { coarse, fine };

/// @param formed   The part of the wake that is formed, which (1) is multiplied by (wake.h).
LoadJacobian load_jacobian(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                           const Coefficients& coefficients, Pieces pieces = Pieces::coarse,
                           double formed = 1);

}  // namespace hydro
