#pragma once

#include <filesystem>

#include "app/scene/yaml_reader.h"

/// @file
/// Files that a scene includes: `include: [common.yaml]`.

namespace scene {

inline constexpr const char* kInclude = "include";

/// Puts the content of the files that a tree includes into it, and that of the files that these
/// include, and removes the key.
///
/// A later file overrides an earlier one, and the tree overrides all files: maps are joined key by
/// key; lists of maps are joined, where entries of the same name become one; any other value
/// replaces the earlier one, and null removes it. Paths of files in an included file are relative
/// to the folder of that file, and are written anew relative to the scene's.
/// @param file   The scene.
/// @throws InputError if a file cannot be read or includes itself
void include_files(YamlNode& root, const std::filesystem::path& file);

}  // namespace scene
