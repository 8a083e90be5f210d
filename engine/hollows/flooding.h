#pragma once

#include "engine/motion/carried_water.h"

/// @file
/// Water that runs into, out of and between the pockets of a hollow body (carried_water.h), in a
/// substep of length h at its final pose.
///
/// Over a sill, by the length of its level projection, and through an opening of the area a run
///
///     q = (2/3)^(3/2) √g H₁^(3/2) (1 − (H₂/H₁)^(3/2))^0.385,      Q = C_d a √(2g |ΔH|)    (E20)
///
/// with the heads H above the sill upstream and downstream [V47], and the difference ΔH of the
/// heads at the opening. With the volume E that makes the levels equal, the substep takes
///
///     ΔV = Q h − (Q h)²/(4E) while Q h < 2E, and E beyond                                   (E21)
///
/// which is exact for an opening between spaces with upright walls, and never overshoots.
///
/// A pump brings
///
///     Q = Q₀ √(1 − H/H₀), Q₀ where H < 0,                                                   (E40)
///
/// with the lift H from the level at its suction to that at its outlet, or to the outlet where that
/// is higher, and no more than stands above its suction.
///
/// In a void that traps its air this adds to the heads at openings (trapped_air.h).
///
/// A pocket over whose sill the sea runs is flooded once both levels agree, or once it is full
/// while all of its sill is under water: nothing holds back the sea then. It is parted from the sea
/// when no water above a sill connects it any more, full to the lowest of its sills to the sea.
/// Pressure is continuous where levels agree. Water goes from high to low, and what comes in shares
/// the momentum of the body, so still water gives no energy.
///
/// The loads of the next substep are those of its middle, so what runs is that of a time h about
/// the end of this one: by the state of the end or, where the water over a sill or opening changes
/// by more than half of its height in this time, as where the sill crosses the surface, or a pocket
/// joins the sea or parts from it, in kWaterParts parts on the way of the body (substep_path.h). So
/// a rim that dips for a part of a substep takes what it takes in shorter ones, and the volume at
/// which a pocket joins the sea hardly depends on h.
///
/// The pockets are searched for anew where the body has turned; those that are found are taken only
/// if they spill at another height or hold another volume than the ones at hand. As long as all
/// sills are above the sea and the water inside, nothing of this is computed.
///
/// [V47] Villemonte. Submerged-weir discharge studies. Engineering News Record 139 (1947) 866-869.

namespace engine {

/// The water of a body after a substep of length h [s] that has led it from the state `before` to
/// this motion at `time` [s], and what its mass does to the velocity.
/// @param rates   Flows of its pumps without a lift [m^3/s].
void let_water_run(const Body& body, const hydro::BodyState& before, double time, double h,
                   const std::vector<double>& rates, Motion& motion);

}  // namespace engine
