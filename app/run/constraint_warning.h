#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/counts.h"
#include "engine/base/spec.h"

namespace app {

/// Returns a warning if the forces of contacts, joints and lines missed their tolerance in a
/// substep of a run: it names the body to which that happened most often.
/// @param counts   Counts of the run's bodies, in their order.
std::optional<std::string> constraint_warning(const engine::SimulationSpec& spec,
                                              const std::vector<engine::Counts>& counts);

}  // namespace app
