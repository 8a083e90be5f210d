#pragma once

#include <Eigen/Core>

#include "hydro/airy_waves.h"

/// @file
/// Sums over the many waves of an irregular sea at one place, with waves in the lanes of the vector
/// unit. They agree with the sums one wave after the other to round-off, and depend on the vector
/// unit by roundings.

namespace hydro {

/// With fewer waves the sums one after the other take no longer.
inline constexpr std::size_t kFewestWavesInLanes = 8;

/// Elevation of waves of the amplitudes of the components, without a ramp [m].
double elevation_in_lanes(const WaveSurface& waves, double x, double y, double time);

/// The contribution of waves to the water at a place: Φ − ξ of (3) in `head`, and (4).
/// @param down         −z* of (5) [m].
/// @param half_sides   As for mean_velocity(); null: at the point.
/// @param sea          With Airy waves.
WaterMotion airy_waves_in_lanes(const Sea& sea, const Eigen::Vector3d& p_W, double down,
                                const Eigen::Matrix3d* half_sides, double time);

}  // namespace hydro
