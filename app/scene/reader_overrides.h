#pragma once

#include "app/scene/diagnostics.h"
#include "app/scene/override.h"
#include "app/scene/yaml_reader.h"

namespace scene {

/// Puts the value of an override into the tree, making the blocks on the way that are not there and
/// the entries of lists that `[+]` asks for; the value `null` takes away what is there.
/// What it puts there has line 0. Adds a fault if the path cannot be followed or the value is not
/// valid YAML.
void apply_override(const Override& override, YamlNode& root, Faults& faults);

}  // namespace scene
