#pragma once

#include <filesystem>
#include <vector>

#include "app/scene/reader.h"

namespace app {

/// Checks scenes and the meshes that they name without a run. @return the exit code
/// @throws InputError with the faults of all scenes
int check(const std::vector<std::filesystem::path>& scenes,
          const std::vector<scene::Override>& overrides, scene::MeshFormats formats);

/// Prints scenes as YAML without includes, variables and repeated entries. @return the exit code
/// @throws InputError with the faults of these
int print_expanded(const std::vector<std::filesystem::path>& scenes,
                   const std::vector<scene::Override>& overrides);

}  // namespace app
