#pragma once

#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "app/scene/scene.h"

namespace app {

/// Describes lines, machines and controls at the start as aligned rows: of each kind the first few,
/// and how many more there are. @return no line for a scene without them
std::vector<std::string> resolved_rig(const scene::Scene& scene, const assembly::BuiltScene& built);

}  // namespace app
