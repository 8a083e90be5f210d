#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/base/reporter.h"
#include "app/scene/override.h"
#include "app/scene/scene.h"

/// @file
/// The resources of a unit: a scene with all that it needs, in a folder of its own.

namespace fmu {

/// A file that a scene names, and its place in the resources.
struct PackedFile {
  std::filesystem::path source;
  std::string name;  ///< `files/0/hull.stl`
};

/// A scene whose files lie in the resources.
struct PackedScene {
  std::string text;  ///< YAML, without includes, variables and repeated entries.
  std::vector<PackedFile> files;
};

/// Returns a scene as it is packed. Each of its files has a folder, with those that it needs itself
/// (companion_files.h).
/// @throws scene::InputError
PackedScene packed_scene(const std::filesystem::path& file,
                         const std::vector<scene::Override>& overrides);

/// A scene to be packed.
struct SceneSource {
  std::filesystem::path file;
  std::vector<scene::Override> overrides = {};
  scene::MeshFormats formats = scene::MeshFormats::common;
};

/// Writes the resources of a scene to a folder (unit_files.h), with the solutions that its added
/// mass and radiation need, from the store in the user's cache or anew.
/// @throws scene::InputError with the faults of the scene
void write_resources(const SceneSource& source, const std::filesystem::path& folder,
                     app::Reporter& reporter = app::quiet());

}  // namespace fmu
