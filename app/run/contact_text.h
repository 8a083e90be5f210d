#pragma once

#include <string>

#include "engine/base/spec.h"

namespace app {

/// Names the friction and restitution of the bodies, the ground and the pairs that have others than
/// the default ones: `ball: restitution 0.8; ball and ground: friction 0.3`. Empty if none has.
std::string contact_text(const engine::SimulationSpec& spec);

}  // namespace app
