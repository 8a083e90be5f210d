#pragma once

#include "hydro/spatial.h"

namespace app {

/// The state at the part `s` of the time `h` [s] between two: cubic in position and attitude, with
/// the velocities that the two have; of third order, exact at both ends.
hydro::BodyState between(const hydro::BodyState& a, const hydro::BodyState& b, double h, double s);

}  // namespace app
