#pragma once

#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "engine/simulation.h"

namespace app {

/// What a run has made of its scene before the first step: its time and water; per body mesh, mass,
/// draught and added mass; and what will not be computed. Bodies that are alike share a row, and of
/// many kinds of bodies the most frequent have one, so that it stays a dozen lines.
/// @param built   With the bodies' added mass.
/// @param no_pictures   Why none will be made; empty if they will.
std::vector<std::string> resolved_scene(const scene::Scene& scene,
                                        const assembly::BuiltScene& built,
                                        const engine::Skips& skips, const std::string& no_pictures);

}  // namespace app
