#pragma once

#include <filesystem>

namespace app {

/// Writes a scene to start from, with comments. @param name   With or without `.yaml`; a file of
/// that name is left alone. @return the exit code
int new_scene(const std::filesystem::path& name);

}  // namespace app
