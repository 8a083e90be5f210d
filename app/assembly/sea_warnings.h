#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "engine/spec.h"

namespace assembly {

/// Returns what the author of a scene should change about its waves: those that would break or that
/// linear theory does not describe, a step or a mesh that is too coarse for them, ground that they
/// would feel. Each is one line, which begins with the key to change and names the value and the
/// bound.
/// @param spec   Of the same scene.
std::vector<std::string> sea_warnings(const scene::Scene& scene,
                                      const engine::SimulationSpec& spec);

}  // namespace assembly
