#pragma once

#include <optional>
#include <vector>

#include "engine/constraints/prepared_block.h"

/// @file
/// A step of the semi-smooth Newton method for the impulses of an island.
///
/// With A = J S⁻¹ Jᵀ + D over all blocks, v = J u + D p − c and W the diagonal of A, the last
/// impulses tell what each row is taken to do [AC91]:
///
///     a bilateral row holds:                                     v + A δ = 0;
///     a one-sided row holds if p − v/W > 0, and else             p + δ = 0;
///     a bounded row holds if |p − v/W| <= limit, and else        p + δ = ± limit;
///     a contact is open if p₁ − v₁/W₁ <= 0, and then p + δ = 0; else v₁ + (A δ)₁ = 0, v₁ and D
///     being those of the one of its two equations that counts. With
///     t = p_t − v_t/ω, ω the greatest response along its tangents, and R = µ (p₁ − v₁/W₁), it
///     sticks if |t| <= R, and then v_t + (A δ)_t = 0. Else it slides along d = t/|t|, which turns
///     with the change of t:
///         p_t + δ_t = µ (p₁ + δ₁) d + (R/|t|) (1 − d dᵀ) (δ_t − (A δ)_t/ω).
///
/// So each row has an equation
///
///     P δ + Q A δ = b;                                                                   (E37)
///
/// all of them are solved for δ at once.
///
/// [AC91] Alart, Curnier. A mixed formulation for frictional contact problems prone to Newton like
///        solution methods. Comput. Methods Appl. Mech. Eng. 92 (1991) 353-375.

namespace engine {

/// @return p + δ; none if the equations have no solution
std::optional<std::vector<Eigen::Vector3d>> newton_step(
    const std::vector<PreparedBlock>& blocks, const std::vector<Eigen::Vector3d>& impulses,
    const std::vector<Vector6d>& velocities);

}  // namespace engine
