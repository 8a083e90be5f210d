#pragma once

#include <optional>
#include <string>

#include "engine/simulation.h"

namespace app {

/// Time of a step, from the first ones.
struct StepCost {
  double seconds = 0;     ///< Wall time of a step [s].
  bool at_least = false;  ///< The step was left after that time.
  double loads = 0;       ///< Part of it that loads and added mass take [-].
};

/// Takes the first steps of a simulation, for about a tenth of a second, and puts its state back.
/// @return none where a step fails, and of a scene without bodies
std::optional<StepCost> measured_cost(engine::Simulation& simulation);

/// `12 ms a step, 1.4 x real time, 95 % of it loads`, with the keys to change where that is slower
/// than real time.
std::string cost_text(const StepCost& cost, const engine::SimulationSpec& spec);

}  // namespace app
