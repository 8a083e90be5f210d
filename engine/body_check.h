#pragma once

#include "engine/spec.h"

namespace engine {

/// Refuses a body that no solid could be: mass not positive; inertia not symmetric, not positive
/// definite, or with a principal moment above the sum of the other two (to 1e-6 of the largest);
/// an initial state that is not finite or not a unit quaternion; no triangles to collide with; a
/// mesh beyond kLargestState.
/// @throws std::invalid_argument naming the body and what is wrong.
void check_body(const BodySpec& spec);

/// Refuses ground that lies beyond kLargestState: what collides there has no place in the engine.
/// @throws std::invalid_argument saying what is wrong.
void check_ground(const Ground& ground);

}  // namespace engine
