#pragma once

#include "hydro/loads/clip.h"
#include "hydro/loads/coefficients.h"
#include "hydro/spatial.h"

/// @file
/// The loads on one flat, wet panel, by closed forms.
///
/// All integrands are polynomials on the panel. With barycentric coordinates λ_i,
///
///     ∫ λ_0^a λ_1^b λ_2^c dA = 2A a! b! c! / (a + b + c + 2)!                             [EM73]
///
/// For a linear function f with vertex values f_i and S = f_0 + f_1 + f_2, and for a quadratic form
/// q = Σ_ij λ_i λ_j q_ij, this gives
///
///     ∫ f dA = A S / 3            ∫ f r dA = (A/12) Σ_i (S + f_i) r_i                      (1)
///     w_i = (1/A) ∫ λ_i q dA = (3q_ii + q_jj + q_kk + 2(q_ij + q_ik) + q_jk) / 30          (2)
///     ∫ q dA = A Σ_i w_i          ∫ q r dA = A Σ_i w_i r_i                                 (3)
///
/// Frames   r, n and velocities in W axes, r relative to the centre of mass; moments about it.
/// Units    SI.
/// Sign     n points out of the body into the water; a load is what the water does to the body.
/// Errors   No function throws. Nothing divides by an area or a sum: a panel without area has no
/// load.
///
/// [EM73] Eisenberg, Malvern. On finite element integration in natural co-ordinates.
///        Int. J. Numer. Methods Eng. 7 (1973) 574-575.

namespace hydro {

/// Load of a pressure linear on the panel, from its vertex values [Pa], by (1): F = −∫ p n dA.
Wrench pressure_load(const Panel& panel, const Eigen::Vector3d& pressure);

/// Pressure drag where the panel moves into the water (sign = +1) or out of it (−1) everywhere:
/// F = −k·sign ∫ v_n² n dA, by (2) and (3) with q_ij = v_n,i v_n,j.
///
/// @param k               ½ ρ C_p [kg/m^3].
/// @param normal_speed    |v_n| at the vertices [m/s], all >= 0: no term of (2) cancels another.
/// @param normal          Unit normal n of the panel.
Wrench pressure_drag_load(const Panel& panel, const Eigen::Vector3d& normal,
                          const Eigen::Vector3d& normal_speed, double sign, double k);

/// Lift: F = −k ∫ |v_t|² n dA with v_t = v − (v·n) n, by (2) and (3) with q_ij = v_t,i · v_t,j: the
/// tangential direction may vary over the panel, as on a spinning body.
///
/// @param velocity   Velocity of the body relative to the water at the vertices, a column each, W
///                   [m/s].
/// @param k          ½ ρ C_l [kg/m^3].
Wrench lift_load(const Panel& panel, const Eigen::Vector3d& normal, const Eigen::Matrix3d& velocity,
                 double k);

}  // namespace hydro
