#pragma once

#include <string>
#include <vector>

#include "app/logs/trajectory.h"

/// @file
/// The motion of a body as columns of numbers, for plots.

namespace app {

/// x y z [m], roll pitch yaw [deg], vx vy vz [m/s], wx wy wz [rad/s].
const std::vector<std::string>& motion_columns();

/// The columns of motion_columns() of a track; angles go on beyond a half turn.
std::vector<std::vector<double>> motion_of(const BodyTrack& track);

}  // namespace app
