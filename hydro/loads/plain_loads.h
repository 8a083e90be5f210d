#pragma once

#include "hydro/loads/loads.h"

/// @file
/// The loads, panel by panel, as the equations are written: what the kernel is held against.

namespace hydro {

/// The same as `compute_loads` by the shortest way in the code: each face is split where the
/// surface bends over it, cut at the waterline and at v·n = 0, and summed by the functions of
/// `panel_loads.h` and `viscous_drag.h`, or at six points. Some twenty times slower than the
/// kernel.
/// @param how   No branches are taken whole; the tolerance holds for panels that are split.
Loads plain_loads(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                  const Coefficients& coefficients, const LoadAccuracy& how = {});

/// The same as `wind_load` for a sea with air. By a power law it is within 1e-4 of the integral,
/// which the kernel is not; in waves all faces are split where the surface bends over them.
Wrench plain_wind(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                  const Coefficients& coefficients);

}  // namespace hydro
