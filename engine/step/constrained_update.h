#pragma once

#include "engine/constraints/island.h"
#include "engine/step/step_context.h"

/// @file
/// The change of velocity of bodies under joints, locks, contacts, lines and drives.
///
/// With S the effective inertia of a body and F its loads (velocity_update.h), R the reactions,
///
///     S Δu = h (F + R),                                                                    (E7)
///
/// where u⁺ = u + Δu and R = Jᵀp/h, and the reactions of locks, obey the rows of all constraints
/// (E8). Locks are no rows: they leave S⁻¹ the velocities that they allow. The rows of joints
/// reverse the velocity at the joint,
///
///     J u⁺ = −J u⁻,                                                                       (E7a)
///
/// so that their work ½ p·J (u⁻ + u⁺) is none, and what the first half of the substep has brought
/// between the sides of a joint closes in the second (joint_closing.h).
///
/// The step does not depend on a lagged acceleration: S has the whole added mass. Where the loads
/// are stiff they are linearised about the change that the constraints lead to, and the constraints
/// solved anew until both agree. In waves where they do not, the loads are linearised on finer
/// pieces of the hull; where they still do not, the result that is nearest to its linearisation
/// counts.

namespace engine {

/// Solves (E7) for a constrained island whose midpoints are made; sets the update and the reactions
/// of each body. Several islands may be solved at once.
/// @param time   Halfway through the substep [s].
void constrained_update(const StepContext& context, Island& island, double time, double h);

}  // namespace engine
