#pragma once

#include <vector>

#include "engine/base/spec.h"
#include "engine/contacts/contact_memory.h"
#include "engine/contacts/world.h"
#include "engine/motion/moving_body.h"

/// @file
/// Suction of a soft sea bed: what a body that lies on it must be pulled with to come free.
///
/// Water can reach the gap below a body only through the soil, so a pull makes the pressure there
/// fall before the body moves. With A the area of its footprint, p the pressure that the bed can
/// hold and T its time, the bed holds the body with
///
///     F = b p A,    b' = (N − F)/(p A T),    0 ≤ b ≤ 1,                                  (E41)
///
/// N the normal force of its contacts. The bond b falls as fast as the pull F − N draws water in,
/// and grows as a body that is pressed down squeezes it out. A constant pull f, over weight and
/// buoyancy, frees a body after
///
///     t = T (p A/f − 1),
///
/// at once for f >= p A: the product of pull and time is nearly constant, as break-out tests show
/// (Muga 1967; Foda, J. Fluid Mech. 123, 1982).
///
/// The footprint is the convex hull of the points of contact, seen from above. A body on
/// an edge or a corner has none and is not held, so lifting one end takes half the force. A body
/// that touches the ground at the start has lain there: its bond begins at 1. One that comes later
/// begins at 0, and one that rises without contact has lost its bond.

namespace engine {

/// Refuses a suction whose pressure is negative or whose time is not positive, and one without
/// ground or under ODE's own step. @throws std::invalid_argument saying what is wrong.
void check_suction(const SimulationSpec& spec);

/// Bonds the bodies that lie on the ground at the start.
/// @param step   The scene's [s].
void begin_suction(World& world, const BedSuction& bed, double step,
                   std::vector<MovingBody>& bodies);

/// Advances the suction of each body that has one by a step.
/// @param forces   Of all contacts, at the end of the step; their pairs ascend.
void advance_suction(const BedSuction& bed, const std::vector<ContactForce>& forces, double step,
                     std::vector<MovingBody>& bodies);

}  // namespace engine
