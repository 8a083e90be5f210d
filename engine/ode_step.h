#pragma once

#include "engine/substep.h"

namespace engine {

/// A step of all bodies as ODE takes it: semi-implicit Euler, first order, with the loads of its
/// start. It knows no added mass, and stiff drag may add energy: it is the plain method that the
/// split step is measured against.
/// @throws MotionFault, OdeFault
void ode_step(const StepContext& context, double time, double step);

}  // namespace engine
