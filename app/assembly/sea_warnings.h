#pragma once

#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "app/scene/scene.h"

namespace assembly {

/// Returns what the author of a scene should change about its waves: those that would break or that
/// linear theory does not describe, a step that is too long for them, ground that they would feel.
/// Each is one line, which begins with the key to change and names the value and the bound. Meshes
/// need no warning: faces that waves bend over are split.
/// @param built   Of the same scene, with its sea and ground.
std::vector<std::string> sea_warnings(const scene::Scene& scene, const BuiltScene& built);

}  // namespace assembly
