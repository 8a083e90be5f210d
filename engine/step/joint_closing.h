#pragma once

#include <vector>

#include "engine/constraints/island.h"
#include "engine/step/step_context.h"

/// @file
/// The end of a substep on joints.
///
/// A substep of an island begins and ends with its bodies on their joints, and with velocities that
/// the joints allow. In between, the drifts turn bodies whose centres move straight on; halfway,
/// the reactions turn the velocity at each joint round (E7a), so that what has come between its
/// sides in the first half closes in the second. An error of third order in the turn remains, or
/// more where a load sets in. Two projections take it away. The poses move by
///
///     J δ = −e,          δ = S⁻¹ Jᵀ p                                                  (E38)
///
/// repeated until e is round-off. They keep ω in B and v in W, or, under added mass, v relative to
/// the water in B, too, and so the kinetic energy. After that the velocities change by
///
///     J (u + Δu) = 0,    Δu = S⁻¹ Jᵀ p,                                                 (E39)
///
/// which can but take energy, by impulses between bodies. Both act on any joint, and on chains of
/// any length and ratio of masses.

namespace engine {

/// Both for bodies at the start of a step, ascending, with all that joints connect them with: a
/// program, or the scene, may have put them off their joints.
void begin_on_joints(const StepContext& context, const std::vector<BodyId>& bodies);

/// Puts the ends of an island's bodies on their joints (E38).
void close_joints(const StepContext& context, Island& island);

/// Takes from the velocities at the ends what joints do not allow (E39), and adds that to their
/// reactions. @param h   Length of the substep [s].
void stop_joints(const StepContext& context, Island& island, double h);

}  // namespace engine
