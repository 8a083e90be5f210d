#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "hydro/spatial.h"

/// @file
/// The motion of bodies over time in a log.

namespace app {

/// The numbers of a state in the order of the columns, x to wz.
using StateRow = std::array<double, 13>;
StateRow row_of(const hydro::BodyState& state);
hydro::BodyState state_of(const StateRow& row);

/// The states of one body over time.
struct BodyTrack {
  std::vector<double> times;  ///< Ascending [s].
  std::vector<hydro::BodyState> states;
};

/// A trajectory read back.
struct Trajectory {
  std::vector<std::string> names;  ///< In the order of their first rows.
  std::map<std::string, BodyTrack> tracks;
};

/// Adds a row to a body's track. Times must ascend, and quaternions must have unit length to within
/// 0.01.
/// @return the fault of the row; empty if there is none
std::string add_row(const std::string& name, double time, const StateRow& row, BodyTrack& track);

}  // namespace app
