#pragma once

#include "engine/spec.h"

namespace engine {

/// The load at a time on a body in the given state: moment about the centre of mass, in W. Zero
/// outside [start, end).
hydro::Wrench wrench(const AppliedLoad& load, const hydro::BodyState& state, double time);

/// True if it still changes after that time, in the axes that it is given in.
bool changes_after(const AppliedLoad& load, double time);

}  // namespace engine
