#pragma once

#include <filesystem>
#include <vector>

#include "app/scene/reader.h"

namespace app {

/// Reads scenes and the meshes that they name, and runs nothing. @return the exit code
/// @throws InputError with the faults of all scenes
int check(const std::vector<std::filesystem::path>& scenes,
          const std::vector<scene::Override>& overrides);

}  // namespace app
