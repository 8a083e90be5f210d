#pragma once

#include <string>

#include "tests/stress/scenario.h"

namespace stress {

/// Returns the height of a body's lowest point above its centre of mass, in its initial orientation
/// [m].
double lowest(const engine::BodySpec& body);

/// Adds the body to the scenario, with the other bodies, joints and ground that the run's `with`
/// names.
///
/// free: nothing; locked: x, y and yaw are locked; pinned, hinged, slider: a joint to the world;
/// chain: three copies hang from the world by ball joints; fixed: two copies with a fixed joint;
/// floor, terrain: ground half the body's height below the water, or under the body if that starts
/// deep; wall: a force as large as its weight pushes the body against a vertical face; stack: three
/// copies on the floor; overload: a stack whose uppermost body has a hundred times the mass; two:
/// two copies side by side; the others are those of rigging.h.
/// @throws std::invalid_argument for an unknown name.
void arrange(const std::string& with, const engine::BodySpec& body, Scenario& scenario);

}  // namespace stress
