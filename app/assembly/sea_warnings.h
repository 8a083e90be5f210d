#pragma once

#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "app/scene/scene.h"
#include "hydro/sea.h"

namespace assembly {

/// True for a wave that would break by itself, and for a height field steeper than water stands.
bool breaks(const hydro::Sea& sea);

/// Returns what the author of a scene should change about its waves: those that would break or that
/// linear theory does not describe, a step that is too long for them, ground that they would feel;
/// and a height field that is too steep for water.
/// Each is one line, which begins with the key to change and names the value and the bound. Meshes
/// need no warning: faces that waves bend over are split.
/// @param built   The same scene as built, with its sea and ground.
std::vector<std::string> sea_warnings(const scene::Scene& scene, const BuiltScene& built);

}  // namespace assembly
