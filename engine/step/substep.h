#pragma once

#include "engine/constraints/island.h"
#include "engine/step/step_context.h"

/// @file
/// One substep of an island: half a drift, an update of the velocities, half a drift.
///
/// An island is a free body, or the bodies that joints, contacts and lines connect in this substep.
/// Bodies that loads of lines alone connect, and free ones, solve S Δu = h F each for itself, with
/// locks and a reduced joint as projections (E5, E6); the others solve S Δu = h (F + R) with the
/// reactions R of joints, contacts and rows (E7). In both, the
/// added mass at the end is that of the expected pose; the update is repeated with that of the pose
/// that it leads to until both agree.

namespace engine {

/// Drifts the body to the middle of a substep of length h [s], where contacts are looked for.
void drift_halfway(SubstepBody& member, double time, double h);

/// Finds the motion of each body of the island at the end of the substep; moves none.
/// A constrained island must have been drifted halfway.
/// @param time   At the start of the substep [s].
/// @throws MotionFault, OdeFault
void take_substep(const StepContext& context, Island& island, double time, double h);

}  // namespace engine
