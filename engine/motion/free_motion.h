#pragma once

#include "engine/base/spatial_vector.h"
#include "engine/base/spec.h"

/// @file
/// Drift: motion of a body by its own inertia and that of the water it moves, without loads.
///
/// In body axes, with velocity u = (v, ω) relative to the water and S = M + A, the momentum
/// p = S u = (P, L) obeys Kirchhoff's equations [L32, ch. VI]
///
///     P' = P × ω,      L' = L × ω + P × v,                                                (E1)
///
/// whose last term is the Munk moment. Screws and other rotors that spin relative to the body at
/// held speeds have a momentum H in it besides: p = S u + (0, H). The midpoint rule integrates
/// them; with a = tan(|ω̄| Δt/2)/|ω̄| for half the time and over-bars for means of both ends,
///
///     P₁ − P₀ = 2a P̄ × ω̄,      L₁ − L₀ = 2a (L̄ × ω̄ + P̄ × v̄),      ū = S⁻¹ (p̄ − (0, H)),  (E2)
///
/// and the pose follows as
///
///     R₁ = R₀ exp(ω̄ Δt),
///     x₁ − x₀ = b R₀ (v̄ + a ω̄ × v̄) + (Δt − b) (v̄·P̄ / P̄·P̄) R₀ P₀,   b = 2a/(1 + a²ω̄²).    (E3)
///
/// The change of p in (E2) is normal to ū, so the energy ½ u·S u is kept exactly; exp(ω̄ Δt) is
/// the Cayley transform of 2a ω̄, so the momentum R P in W is kept, too; and (E3) is the
/// displacement that keeps x × R P + R L. All this holds for any Δt, so the motion never diverges.
/// A second-order error of phase remains: drifts are divided so that the body turns by kLargestTurn
/// at most. A uniform current is an inertial frame and carries the motion along.
///
/// [L32] Lamb. Hydrodynamics. 6th ed., Cambridge (1932).

namespace engine {

/// The right-hand sides of (E1): the load, normal to u, that a momentum p = (P, L) brings to axes
/// that move with the velocity u. Both in the same axes.
Vector6d kirchhoff(const Vector6d& p, const Vector6d& u);

/// Rate at which (E1) turns the velocity u in B and its momentum, with S and H in B [rad/s].
double turning_rate(const Matrix6d& S, const Vector6d& u,
                    const Eigen::Vector3d& rotors = Eigen::Vector3d::Zero());

/// The state after `time` [s] of (E1).
/// @param inertia_B   S, symmetric and positive definite.
/// @param rotors_B    H [N m s].
hydro::BodyState drifted(const Matrix6d& inertia_B, const hydro::BodyState& state,
                         const Eigen::Vector3d& current, double time,
                         const Eigen::Vector3d& rotors_B = Eigen::Vector3d::Zero());

/// The same for a body without added mass: its centre moves straight on, and its rotation obeys
/// Euler's equations.
hydro::BodyState drifted(const BodySpec& body, const hydro::BodyState& state, double time,
                         const Eigen::Vector3d& rotors_B = Eigen::Vector3d::Zero());

/// The state after `time` [s] of free rotation about the centre of mass, or any other fixed point
/// about which the body has this moment of inertia; the position stays.
hydro::BodyState rotated_freely(const Eigen::Matrix3d& inertia_B, const hydro::BodyState& state,
                                double time,
                                const Eigen::Vector3d& rotors_B = Eigen::Vector3d::Zero());

/// The state after `time` [s] with locked degrees of freedom. In W, with p = S u and the index f
/// for the free components,
///
///     p_f' = (0, −v × P)_f,    the other velocities are constant,                        (E1a)
///
/// by the midpoint rule; without a free rotation all velocities are constant. The locks do work.
/// With the index c for locked components,
///
///     ½ u_f·S u_f − ½ u_c·S u_c                                                          (E3a)
///
/// is constant, and by the midpoint rule to its order. Parts that do not keep it are halved, so the
/// motion never diverges here either.
hydro::BodyState drifted(const Matrix6d& inertia_B, const DofMask& locked,
                         const hydro::BodyState& state, const Eigen::Vector3d& current, double time,
                         const Eigen::Vector3d& rotors_B = Eigen::Vector3d::Zero());

/// exp of a rotation vector [rad].
Eigen::Quaterniond exponential(const Eigen::Vector3d& turn);

/// The unit quaternion turned about axes in W. Its length is 1 to the square of round-off.
Eigen::Quaterniond rotated(const Eigen::Quaterniond& orientation, const Eigen::Vector3d& turn_W);

}  // namespace engine
