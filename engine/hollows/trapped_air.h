#pragma once

#include "engine/hollows/spaces.h"

/// @file
/// The air that is trapped in the voids of a body.
///
/// While no air passes, its pressure times its volume V, pV, stays as it is (Boyle's law): water
/// that comes in changes its temperature little. With the pressure p₀ of the atmosphere it adds to
/// the level of the water below it the head
///
///     H = (pV/V − p₀)/(ρ g).                                                                (E42)
///
/// Air passes an opening at once, from the side on which air is at the opening to the other one,
/// until the pressure there is no lower: between voids, to and from the atmosphere, and as bubbles
/// into water. Air and water do not pass each other in one opening. On the walls of a void its
/// pressure cancels but for the area of openings, which is left out; it has no mass.

namespace engine {

/// True if the space is a void of a body that traps its air.
bool traps_air(const Spaces& spaces, int space);

/// H of a pocket [m]; 0 where no air is trapped.
double air_head(const Spaces& spaces, int pocket);

/// −dH/dV of the air that water meets in a space [1/m^2]; 0 where none is trapped, or where an
/// opening lets it out to the atmosphere.
double air_stiffness(const Spaces& spaces, int space);

/// Lets air pass through all openings of the body.
void pass_air(Spaces& spaces);

}  // namespace engine
