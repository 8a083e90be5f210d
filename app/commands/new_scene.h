#pragma once

#include <filesystem>

namespace app {

/// Writes a commented starter scene. An existing file is not changed.
/// @param name   Name with or without `.yaml`.
/// @return the exit code
int new_scene(const std::filesystem::path& name);

}  // namespace app
