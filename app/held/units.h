#pragma once

#include <string>

#include "app/scene/rig_names.h"
#include "app/scene/scene.h"
#include "engine/base/spec.h"

/// @file
/// Units of what a simulation is told and reads, as texts: `m/s^2`, `N m`, `deg`, `1`.

namespace app {

/// Returns the unit of a set point in its name.
std::string units_of(const scene::SetPoint& set_point, const scene::Scene& scene);

/// Returns the unit of a quantity of a body (scene::measurable) or a column of its motion:
/// `heading_deg`, `vx`.
std::string units_of_motion(const std::string& quantity);

/// Returns the unit of a column of a probe (sensors.h).
std::string units_of_probe(const std::string& column);

/// Returns the unit of a joint's series, which may depend on the kind of the joint.
/// @param units   The unit in the table's layout: `rad or m`.
std::string units_of_joint(const std::string& units, const engine::JointSpec& joint);

}  // namespace app
