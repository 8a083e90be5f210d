#pragma once

#include "hydro/spatial.h"

namespace app {

/// Returns the state at the fraction `s` of the interval `h` [s] between two states. Position and
/// attitude are Hermite cubics that match the velocities, which are interpolated linearly. The
/// result is of third order and exact at both ends.
hydro::BodyState between(const hydro::BodyState& a, const hydro::BodyState& b, double h, double s);

}  // namespace app
