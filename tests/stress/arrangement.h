#pragma once

#include <string>

#include "tests/stress/scenario.h"

namespace stress {

/// Height of a body's lowest point above its centre of mass, in its initial orientation [m].
double lowest(const engine::BodySpec& body);

/// Puts the body into the scenario with what the run's `with` says: other bodies, joints, ground.
///
/// free; locked: x, y and yaw are; pinned, hinged, slider: to the world; chain: three of it by ball
/// joints from the world; fixed: two by a fixed joint; floor, terrain: ground under it, half the
/// body's height below the water, or under the body if that starts deep; wall: its weight pushes it
/// against a vertical face; stack: three on the floor; overload: the uppermost with a hundred times
/// the mass.
/// @throws std::invalid_argument for an unknown name.
void arrange(const std::string& with, const engine::BodySpec& body, Scenario& scenario);

}  // namespace stress
