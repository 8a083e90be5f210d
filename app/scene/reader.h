#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/scene/override.h"
#include "app/scene/scene.h"

/// @file
/// Reads scenes.

namespace scene {

/// True if the extension of a file is .yaml or .yml.
bool is_scene_file(const std::filesystem::path& file);

/// Reads and checks a scene file.
/// @param formats   Formats of meshes that may be read when the scene is built.
/// @throws InputError with every fault, in the order of the file but those of overrides first.
Scene read(const std::filesystem::path& file, const std::vector<Override>& overrides = {},
           MeshFormats formats = MeshFormats::common);

/// Returns a scene as YAML without includes, variables and repeated entries, and with the overrides
/// put in.
/// @throws InputError with the faults of these, others are not looked for
std::string resolved_text(const std::filesystem::path& file,
                          const std::vector<Override>& overrides);

/// Returns the text of a scene likewise.
/// @param file   File named in faults, from whose folder it includes files.
std::string resolved_text_of(const std::string& text, const std::filesystem::path& file,
                             const std::vector<Override>& overrides);

/// Reads and checks the text of a scene.
/// @param file   File named in faults; paths in the scene are relative to its folder.
Scene parse(std::string text, const std::filesystem::path& file,
            const std::vector<Override>& overrides, MeshFormats formats = MeshFormats::common);

}  // namespace scene
