#pragma once

#include "engine/base/rig_spec.h"
#include "hydro/spatial.h"

namespace engine {

/// Returns a quantity of a body's motion, in SI units.
/// @param quantity   One of a body, `x` to `turn_rate`.
/// @param level      Height of the still water in W [m].
double body_quantity(Measurement::Quantity quantity, const hydro::BodyState& state, double level);

}  // namespace engine
