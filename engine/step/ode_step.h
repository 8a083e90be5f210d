#pragma once

#include <vector>

#include "engine/record/constraint_errors.h"
#include "engine/step/step_context.h"

namespace engine {

/// Takes a step of all bodies by ODE alone: semi-implicit Euler, of first order, with the loads of
/// its start. There is no added mass, and stiff drag may add energy. The method is for comparison.
/// @return the overlaps at its start. @throws MotionFault, OdeFault
std::vector<Overlap> ode_step(const StepContext& context, double time, double step);

}  // namespace engine
