#pragma once

#include <string>

#include "tests/engine/specs.h"

/// @file
/// Small parts of a rig for tests: lines and set points with few words.

namespace support {

/// A spring or rope between two points; kWorld is the world.
inline engine::LineSpec line(engine::LineSpec::Kind kind, engine::AttachmentPoint first,
                             engine::AttachmentPoint second, double length, double stiffness,
                             double damping = 0) {
  return {.name = "line",
          .kind = kind,
          .first = first,
          .second = second,
          .length = length,
          .stiffness = stiffness,
          .damping = damping};
}

/// Adds a set point. @return its id
inline engine::SetPointId add_set_point(engine::SimulationSpec& spec, const std::string& name,
                                        double initial, double unit = 1) {
  spec.set_points.push_back({.name = name, .initial = initial, .unit = unit});
  return static_cast<engine::SetPointId>(spec.set_points.size()) - 1;
}

}  // namespace support
