#pragma once

#include "app/scene/diagnostics.h"
#include "app/scene/override.h"
#include "app/scene/yaml_reader.h"

namespace scene {

/// Sets the value of an override in the tree, and creates missing blocks on its path and the list
/// entries that `[+]` asks for. The value `null` removes the key or entry. New values have line 0.
/// A path that cannot be followed, or a value that is not valid YAML, is a fault.
void apply_override(const Override& override, YamlNode& root, Faults& faults);

}  // namespace scene
