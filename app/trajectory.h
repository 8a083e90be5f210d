#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/row_file.h"
#include "hydro/spatial.h"

/// @file
/// Trajectories as CSV: `time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz`, one row a body a time.

namespace app {

/// Writes a trajectory while it is made. What was added is in the file when `add` returns.
class TrajectoryWriter {
 public:
  /// Replaces the file. @throws InputError if it cannot be written.
  TrajectoryWriter(const std::filesystem::path& file, std::vector<std::string> names);

  /// One row a body, in the order of the names, with digits that read back to the same numbers.
  /// @throws OutputError if the disk is full.
  void add(double time, const std::vector<hydro::BodyState>& states);

 private:
  std::vector<std::string> names_;
  RowFile file_;
};

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

/// Reads a trajectory; quaternions must be of unit length to 1 %. A last line that was cut off is
/// left out.
/// @throws InputError with the line at fault.
Trajectory read_trajectory(const std::filesystem::path& file);

}  // namespace app
