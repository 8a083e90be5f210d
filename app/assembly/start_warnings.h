#pragma once

#include <string>
#include <vector>

#include "engine/base/spec.h"

namespace assembly {

/// Returns a line for each pair of bodies, or body and ground, that overlap at the start although
/// both are shrunk by a twentieth: contacts would push them far apart, or hold one inside the
/// other. A line begins with
/// the key to change and names what the body overlaps. Bodies that a joint connects, or that do not
/// collide, may overlap.
std::vector<std::string> start_warnings(const engine::SimulationSpec& spec);

}  // namespace assembly
