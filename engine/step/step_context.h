#pragma once

#include <vector>

#include "engine/base/parallel_for.h"
#include "engine/contacts/world.h"
#include "engine/motion/moving_body.h"
#include "engine/rig/rig.h"

namespace engine {

/// What all substeps of a simulation have in common.
struct StepContext {
  World& world;
  Rig& rig;
  std::vector<MovingBody>& bodies;
  double gravity = 0;  ///< [m/s^2]
  ParallelFor parallel_for;
  bool collides = true;  ///< False: nothing in the scene can touch.
  double tolerance = 0;  ///< As Integrator::tolerance.
};

}  // namespace engine
