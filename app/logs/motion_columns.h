#pragma once

#include <string>
#include <vector>

#include "app/logs/trajectory.h"

/// @file
/// Motion of a body as columns of numbers, for plots.

namespace app {

/// x y z [m], roll pitch yaw [deg], vx vy vz [m/s], wx wy wz [rad/s].
const std::vector<std::string>& motion_columns();

/// Returns the columns named by motion_columns() for a track; angles are continuous, without
/// jumps at ±180° or where the pitch passes ±90°.
std::vector<std::vector<double>> motion_of(const BodyTrack& track);

/// Shifts the angles of a motion by whole turns, so that they start nearest to those of another.
/// @param motion   Columns named by motion_columns(), as those of `other`; neither is empty.
void start_alike(const std::vector<std::vector<double>>& other,
                 std::vector<std::vector<double>>& motion);

}  // namespace app
