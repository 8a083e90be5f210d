#pragma once

#include "engine/body.h"
#include "engine/world.h"

namespace engine {

/// A step of all bodies as ODE takes it: semi-implicit Euler, first order, with the loads of its
/// start. Added mass has no part in it, and nothing keeps stiff drag from adding energy: it is what
/// the split step is measured against.
/// @throws MotionFault, OdeFault
void ode_step(World& world, std::vector<Body>& bodies, const Surroundings& around, double time,
              double step, bool collides);

}  // namespace engine
