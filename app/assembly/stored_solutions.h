#pragma once

#include <filesystem>

#include "app/assembly/built_scene.h"

namespace assembly {

/// Copies the solutions of added mass and radiation that a scene needs from the folder of one store
/// to that of another. One that the first store lacks is left out, and so is the resistance of
/// waves: whoever builds the scene with the second store solves for them anew.
/// @param built   With added mass.  @param to   A folder; it is made.
/// @throws std::filesystem::filesystem_error
void copy_solutions(const scene::Scene& scene, const BuiltScene& built,
                    const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace assembly
