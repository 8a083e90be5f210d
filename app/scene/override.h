#pragma once

#include <string>

#include "app/scene/diagnostics.h"

namespace scene {

/// A value that replaces or adds one key of a scene: `--set bodies[0].density=700`.
struct Override {
  std::string key_path;  ///< Entries of a list by index or by name: `bodies[teapot].density`.
  std::string value;     ///< YAML.
};

/// Splits `KEY.PATH=VALUE`. @throws InputError if there is no `=` or no key.
Override parse_override(const std::string& argument);

}  // namespace scene
