#pragma once

#include <vector>

#include "engine/motion/moving_body.h"
#include "engine/record/constraint_errors.h"
#include "engine/rig/rig.h"
#include "engine/simulation_state.h"
#include "engine/step/stepper.h"

namespace engine {

/// The part of a simulation state that belongs to one body.
struct BodyRecord {
  Motion motion;
  Inputs inputs;
  Counts counts;
  std::optional<hydro::BodyState> water_state;  ///< As that of LoadCache.
};

struct SimulationState::Data {
  long steps = 0;
  std::vector<BodyRecord> bodies;
  StepperState stepper;
  RigState rig;
  ConstraintErrors errors;
  std::string water;  ///< State of the simulated water; empty without it.
};

}  // namespace engine
