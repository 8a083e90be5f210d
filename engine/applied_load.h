#pragma once

#include "engine/spec.h"

namespace engine {

/// The load at a time on a body in the given state: moment about the centre of mass, in W. Zero
/// outside [start, end).
hydro::Wrench wrench(const AppliedLoad& load, const hydro::BodyState& state, double time);

}  // namespace engine
