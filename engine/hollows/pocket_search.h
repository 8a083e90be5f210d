#pragma once

#include "engine/motion/carried_water.h"

/// @file
/// Which pockets a hollow body has as it turns.
///
/// Pockets that were found in one attitude are good for others in which a new search would find the
/// same spill heights and volumes: the mouth of a bucket is its rim in any attitude. So the surface
/// is divided anew only where a search tells so, and searched only in attitudes that are not near
/// one in which the division at hand was right. Where a body turns out of these attitudes within a
/// substep, it is searched as it leaves them, so that what is found does not depend on the length
/// of the substep: some hulls have a pocket in a small range of attitudes alone. A body that is
/// convex but for its pockets has no others: while they are dry and their sills above the sea, it
/// is not searched at all.

namespace engine {

/// Height in W of the lowest sill; infinite without pockets.
double lowest_sill(const Body& body, const CarriedWater& carried, const hydro::BodyState& state);

/// The water with the pockets that the body has in the state `after` that it has come to from
/// `before` in a substep: `carried`, if they are right. Water goes to the pocket that its lowest
/// point is in. A pocket that was outside has the water that the sea left there.
/// @param time   At the end of the substep [s].
std::shared_ptr<const CarriedWater> divided_for(const Body& body, const hydro::BodyState& before,
                                                const hydro::BodyState& after, double time,
                                                const std::shared_ptr<const CarriedWater>& carried);

}  // namespace engine
