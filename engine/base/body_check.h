#pragma once

#include "engine/base/spec.h"

namespace engine {

/// Refuses a body that is no solid: its mass is not positive; its inertia is not symmetric, not
/// positive definite, or has a principal moment above the sum of the others (kInertiaTolerance);
/// its initial state is not finite, or no unit quaternion; it collides but has no triangles; it has
/// radiation but no added mass; or its mesh reaches beyond kLargestState.
/// @throws std::invalid_argument naming the body and what is wrong.
void check_body(const BodySpec& spec);

/// Refuses a state to start from that is not finite, or whose orientation is no unit quaternion.
/// @throws std::invalid_argument naming the body and what is wrong.
void check_initial_state(const BodySpec& spec, const hydro::BodyState& state);

/// Refuses ground that reaches beyond kLargestState, where the engine cannot find contacts.
/// @throws std::invalid_argument saying what is wrong.
void check_ground(const Ground& ground);

}  // namespace engine
