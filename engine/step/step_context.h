#pragma once

#include <vector>

#include "engine/base/parallel_for.h"
#include "engine/base/step_stopped.h"
#include "engine/contacts/world.h"
#include "engine/motion/moving_body.h"
#include "engine/rig/rig.h"

namespace engine {

/// The inputs that all substeps of a simulation share.
struct StepContext {
  World& world;
  Rig& rig;
  std::vector<MovingBody>& bodies;
  double gravity = 0;  ///< [m/s^2]
  ParallelFor parallel_for;
  bool collides = true;  ///< False: nothing in the scene can touch.
  double tolerance = 0;  ///< As Integrator::tolerance.
  const StopCheck* stop = nullptr;

  /// Is called before the dear parts of a substep, so that it can be left within one of them.
  /// @throws StepStopped
  void check_stop() const {
    if (stop) ask(*stop);
  }
};

}  // namespace engine
