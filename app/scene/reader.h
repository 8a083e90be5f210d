#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/scene/override.h"
#include "app/scene/scene.h"

namespace scene {

/// True if the extension of a file is that of scenes, .yaml or .yml.
bool is_scene_file(const std::filesystem::path& file);

/// Reads and checks a scene file.
/// @throws InputError with every fault found, in the order of the file; those of overrides first.
Scene read(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

/// The same of a text. @param file   Named in faults; files that the scene names are relative to
/// its folder.
Scene parse(std::string text, const std::filesystem::path& file,
            const std::vector<Override>& overrides);

}  // namespace scene
