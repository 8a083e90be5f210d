#pragma once

#include <string>

#include "hydro/sea.h"

namespace stress {

/// Returns the water that a run names, with lengths in proportion to a body's size [m] and level 0.
/// @throws std::invalid_argument for an unknown name.
hydro::Sea make_water(const std::string& name, double size);

/// Returns the largest of the phase speeds of the waves and the speed of the current [m/s].
double fastest(const hydro::Sea& sea);

}  // namespace stress
