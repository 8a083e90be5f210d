#pragma once

#include <string>

#include "hydro/sea.h"

namespace stress {

/// The water named by a run, its lengths in proportion to a body's size [m]; level 0.
/// @throws std::invalid_argument for an unknown name.
hydro::Sea make_water(const std::string& name, double size);

/// The largest speed at which the surface's shape moves over the water, or the water itself [m/s].
double fastest(const hydro::Sea& sea);

}  // namespace stress
