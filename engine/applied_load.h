#pragma once

#include "engine/spec.h"

namespace engine {

/// The load on a body in a state at a time [s]: moment about the centre of mass, in W. Zero outside
/// [start, end).
hydro::Wrench wrench(const AppliedLoad& load, const hydro::BodyState& state, double time);

}  // namespace engine
