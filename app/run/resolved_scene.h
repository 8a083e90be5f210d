#pragma once

#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "engine/simulation.h"

namespace app {

/// Describes a scene as a run resolved it before the first step: time and water; per body mesh,
/// mass, draught, added mass and radiation; and the parts that will not be computed. The tables
/// have few rows (body_tables.h), which keeps the text to a dozen lines.
/// @param built   Scene with the bodies' added mass.
/// @param no_pictures   Reason why no pictures will be made; empty if they will.
std::vector<std::string> resolved_scene(const scene::Scene& scene,
                                        const assembly::BuiltScene& built,
                                        const engine::Skips& skips, const std::string& no_pictures);

}  // namespace app
