#pragma once

#include <filesystem>
#include <vector>

#include "app/scene/reader.h"

namespace app {

/// Prints the forces on every body in its initial state, and the readings of lines, joints and
/// machines, as JSON. @return the exit code
int probe(const std::filesystem::path& scene, const std::vector<scene::Override>& overrides,
          scene::MeshFormats formats);

}  // namespace app
