#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "engine/base/spec.h"

namespace assembly {

/// Returns what the author of a scene should look at: ropes and moorings that are shorter than
/// their span at the start, catenaries that swing as slowly as the waves, and propellers that reach
/// out of the water. Each is one line, which begins with the key. A line of a body that starts in
/// equilibrium has the tension that holds it there.
std::vector<std::string> rig_warnings(const scene::Scene& scene,
                                      const engine::SimulationSpec& spec);

}  // namespace assembly
