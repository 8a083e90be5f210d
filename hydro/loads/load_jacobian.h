#pragma once

#include "hydro/loads/loads.h"

/// @file
/// How the loads on a hull change with its velocity and with its height and heel.
///
/// Pressure drag pushes each part of the skin back along its normal; with b = (n, r × n) and the
/// velocity u about the centre of mass, v_n = b·u and
///
///     ∂F/∂u = −ρ ∫ C_p |v_n| b bᵀ dS,                                                        (1)
///
/// friction along its path: with B the 3×6 matrix of v = B u and t = v_t/|v_t|,
///
///     ∂F/∂u = −½ρ ∫ C_v |v_t| Bᵀ (1 − n nᵀ + t tᵀ) B dS,                                     (2)
///
/// where the change of C_v with speed is left out. Both are symmetric and negative semi-definite.
/// The weight of water that the waterplane takes in or gives back adds, with c = (0, 0, 1, y, −x,
/// 0),
///
///     K = −ρ g ∫_waterplane c cᵀ dA = ρ g ∫_wet c cᵀ n_z dS                                  (3)
///
/// per displacement, by the divergence theorem for c cᵀ ẑ; the turning of the buoyancy's own lever
/// is left out, so that K too is negative semi-definite. Integrals by the rule of the edges'
/// midpoints, whose weights are positive: exact for (3) in still water, to 2nd order elsewhere.
///
/// About the centre of mass, W axes. Lift has no part in it.

namespace hydro {

struct LoadJacobian {
  Matrix6d drag = Matrix6d::Zero();        ///< (1) + (2) [N s/m, N s, N m s].
  Matrix6d waterplane = Matrix6d::Zero();  ///< (3) [N/m, N, N m].
};

LoadJacobian load_jacobian(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                           const Coefficients& coefficients);

}  // namespace hydro
