#pragma once

#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "engine/simulation.h"

namespace app {

/// Describes a scene as a run resolved it before the first step: time and water; per body mesh,
/// mass, draught, added mass and radiation; and the parts that will not be computed. Equal bodies
/// share a row, and only the most frequent kinds of bodies have one, which keeps the text to a
/// dozen lines.
/// @param built   Scene with the bodies' added mass.
/// @param no_pictures   Reason why no pictures will be made; empty if they will.
std::vector<std::string> resolved_scene(const scene::Scene& scene,
                                        const assembly::BuiltScene& built,
                                        const engine::Skips& skips, const std::string& no_pictures);

/// Returns the lines of that text on meshes, sizes, masses and draughts of bodies.
std::vector<std::string> body_sizes(const scene::Scene& scene, const assembly::BuiltScene& built);

}  // namespace app
