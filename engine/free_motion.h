#pragma once

#include "engine/spatial_vector.h"
#include "engine/spec.h"

/// @file
/// Motion of a body by its own inertia and that of the water it moves, without loads.
///
/// In body axes, with velocity u = (v, ω) relative to the water and S = M + A, the momentum
/// p = S u = (P, L) follows Kirchhoff's equations [L32, ch. VI]
///
///     P' = P × ω,      L' = L × ω + P × v,                                                (E1)
///
/// whose last term is the Munk moment. They are integrated by the midpoint rule with a = tan(|ω̄| Δt
/// /2)/|ω̄| for half the step, an over-bar being the mean of both ends,
///
///     P₁ − P₀ = 2a P̄ × ω̄,      L₁ − L₀ = 2a (L̄ × ω̄ + P̄ × v̄),      ū = S⁻¹ p̄,             (E2)
///
/// and the pose by
///
///     R₁ = R₀ exp(ω̄ Δt),
///     x₁ − x₀ = b R₀ (v̄ + a ω̄ × v̄) + (Δt − b) (v̄·P̄ / P̄·P̄) R₀ P₀,   b = 2a/(1 + a²ω̄²).    (E3)
///
/// The change of p in (E2) is normal to ū, so that the energy ½ p·S⁻¹p is kept exactly; exp(ω̄ Δt)
/// is the Cayley transform of 2a ω̄, so that R P, the momentum in W, is; and (E3) is the
/// displacement for which x × R P + R L is. All three hold for any step, so the motion never runs
/// away. What is left is a second-order error of phase; steps are cut so that the body turns by
/// kLargestTurn. A uniform current is an inertial frame: it carries all this along.
///
/// [L32] Lamb. Hydrodynamics. 6th ed., Cambridge (1932).

namespace engine {

/// Rate at which (E1) turns the velocity u in B and its momentum, with S in B [rad/s].
double turning_rate(const Matrix6d& S, const Vector6d& u);

/// The state after `time` [s] of motion by (E1).
///
/// @param inertia_B   S, symmetric and positive definite.
hydro::BodyState drifted(const Matrix6d& inertia_B, const hydro::BodyState& state,
                         const Eigen::Vector3d& current, double time);

/// The same for a body without added mass: its centre moves straight on, its turning follows
/// Euler's equations.
hydro::BodyState drifted(const BodySpec& body, const hydro::BodyState& state, double time);

/// Its orientation and angular velocity after `time` [s] of turning freely, with this moment of
/// inertia, about its centre of mass or any fixed point.
hydro::BodyState turned_freely(const Eigen::Matrix3d& inertia_B, const hydro::BodyState& state,
                               double time);

/// The same with degrees of freedom held: in W axes, with the momenta p = S u and the index f for
/// those that are free,
///
///     p_f' = (0, −v × P)_f,    u constant in the others,                                  (E1a)
///
/// by the midpoint rule. Without a free rotation the velocity stays as it is. What holds the others
/// does work on them; kept is, with the index c for these,
///
///     ½ u_f·S u_f − ½ u_c·S u_c,                                                          (E3a)
///
/// by the midpoint rule to its order. Steps that do not keep it are halved, so that no motion runs
/// away here either.
hydro::BodyState drifted(const Matrix6d& inertia_B, const DofMask& locked,
                         const hydro::BodyState& state, const Eigen::Vector3d& current,
                         double time);

/// exp of a rotation vector [rad].
Eigen::Quaterniond exponential(const Eigen::Vector3d& turn);

/// The orientation, unit, turned about axes in W, then so again but for round-off squared.
Eigen::Quaterniond turned_by(const Eigen::Vector3d& turn_W, const Eigen::Quaterniond& orientation);

}  // namespace engine
