#pragma once

#include <functional>
#include <optional>

#include "engine/contacts/world.h"

/// @file
/// Bodies that would pass through each other in a substep, and the time at which they first touch.
///
/// A substep looks for contacts at places, not on the ways between them. A pair may pass unseen
/// where it moves farther in the substep, relative to each other, than half the thickness of the
/// thinner body (World::reach):
///
///     (|v₁ − v₂| + r₁ ω₁ + r₂ ω₂) h > reach.                                             (E32)
///
/// Only then is its way searched. In the frame of the larger body, the smaller one sweeps, from t₀
/// to t₁, no more than the box along its way that holds its shape at both, with margins for the
/// turn and for the bend of the way. Where this box meets nothing of the larger body the bodies do
/// not touch; elsewhere the interval is halved, the earlier half first, down to a motion of
/// kPassingInterval reach. At its end the bodies are collided, and where they close, the time of
/// first contact follows by bisection to a motion of kPassingError reach. Where they still close
/// half a reach after the end, the contacts of the next substep stop them. Pairs that already close
/// halfway are treated alike, since that contact decides the second half. A free flight costs one
/// query, a box or a collision; a hit costs about 40. Beyond the first one, all searches of a step
/// have kMostPassingQueries per body.
///
/// Validity. A body shows its surface while it moves by its own thickness, so no passing of bodies
/// that are thicker than the reach is missed; two hulls whose walls are far thinner than the boxes
/// around them may pass through each other's walls, and so may corners that cut by less than
/// kPassingInterval reach.

namespace engine {

/// The motion of a pair in a substep.
struct PairMotion {
  Pair pair;
  double h = 0;        ///< Length of the substep [s].
  double speed = 0;    ///< Bound of the relative speed of any two points, (E32) [m/s].
  double turning = 0;  ///< Sum of both angular speeds [rad/s].
  double reach = 0;    ///< World::reach [m].
  double slow = 0;     ///< Speed up to which closing does not count [m/s].
  /// Where a body is at a time from the start of the substep; of kWorld, the pose at the origin. It
  /// is asked for many times, some of them more than once.
  std::function<hydro::BodyState(BodyId, double)> state;
};

/// Time from the start of the substep at which the pair first touches, just before it does [s]; 0
/// where it touches already. None: it does not touch, or does so at the end as well, or no
/// queries are left.
/// @param queries   Boxes and collisions that are left; those that are taken beyond the first are
///   subtracted.
std::optional<double> unseen_contact(World& world, const PairMotion& motion, int& queries);

}  // namespace engine
