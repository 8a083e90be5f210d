#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/scene/faults.h"
#include "app/scene/scene.h"

namespace app {

/// A value that replaces or adds one key of a scene: `--set bodies[0].density=700`.
struct Override {
  std::string key_path;  ///< Entries of a list by index or by name: `bodies[teapot].density`.
  std::string value;     ///< YAML.
};

/// Splits `KEY.PATH=VALUE`. @throws InputError if there is no `=` or no key.
Override parse_override(const std::string& argument);

/// Reads and checks a scene file.
/// @throws InputError with every fault found, in the order of the file; those of overrides first.
Scene read_scene(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

/// The same of a text. @param file   Named in faults; files that the scene names are relative to
/// its folder.
Scene parse_scene(std::string text, const std::filesystem::path& file,
                  const std::vector<Override>& overrides);

}  // namespace app
