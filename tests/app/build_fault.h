#pragma once

#include <string>

#include "app/assembly/build.h"
#include "app/scene/diagnostics.h"
#include "tests/app/scene_text.h"

namespace support {

/// What the program says of a scene that it cannot assemble; empty for one that it can.
inline std::string build_fault(const std::string& text) {
  try {
    assembly::build_without_added_mass(read_scene_text(text));
  } catch (const scene::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace support
