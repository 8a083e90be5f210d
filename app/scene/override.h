#pragma once

#include <string>

#include "app/scene/diagnostics.h"

/// @file
/// Values that are given beside a scene's file.

namespace scene {

/// A value that replaces or adds one key of a scene: `--set bodies[0].density=700`.
struct Override {
  std::string key_path;  ///< List entries have an index or a name: `bodies[teapot].density`.
  std::string value;     ///< The value as YAML.
};

/// Splits `KEY.PATH=VALUE`. @throws InputError if there is no `=` or no key.
Override parse_override(const std::string& argument);

}  // namespace scene
