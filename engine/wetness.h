#pragma once

#include "engine/spec.h"

namespace engine {

/// True if the water can move the body: it is wet, can move, and has a coefficient that is not
/// zero.
bool feels_water(const BodySpec& spec);

/// z of the lowest point of a box in B, for a body in the given state [m]. No point of a mesh that
/// lies in the box is lower.
double lowest_point(const Eigen::AlignedBox3d& box_B, const hydro::BodyState& state);

}  // namespace engine
