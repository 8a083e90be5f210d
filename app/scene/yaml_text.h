#pragma once

#include <string>

#include "app/scene/yaml_reader.h"

namespace scene {

/// Returns a tree as YAML, which reads back to the same tree. Lists of scalars, and maps in lists
/// that hold nothing but scalars, stand on one line.
std::string yaml_text(const YamlNode& root);

}  // namespace scene
