#pragma once

#include <vector>

/// @file
/// Flows of water over sills, through openings and by pumps. Heads and lifts are in metres of
/// water.

namespace engine {

/// q of (E20) over a sill [m^2/s]; 0 for a head upstream that is not positive.
double weir_flow(double upstream, double downstream, double gravity);

/// ΔV of (E21) [m^3].
double limited_flow(double volume, double equalising);

/// Q of (E40) [m^3/s]. @param rate   Q₀ [m^3/s]. @param head   H₀, > 0 [m].
double pump_flow(double rate, double lift, double head);

/// True if one of the pumps runs. @param rates   Q₀ of each [m^3/s].
bool pumping(const std::vector<double>& rates);

}  // namespace engine
