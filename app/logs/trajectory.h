#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/logs/row_file.h"
#include "hydro/spatial.h"

/// @file
/// Trajectories as CSV: `time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz`, one row a body a time.
/// They are read as HDF5 too (hdf5_log.h).

namespace app {

/// The numbers of a state in the order of the columns, x to wz.
using StateRow = std::array<double, 13>;
StateRow row_of(const hydro::BodyState& state);
hydro::BodyState state_of(const StateRow& row);

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

/// Adds a row to those of a body. @return what is wrong with it, empty if nothing is: times must
/// ascend, quaternions be of unit length to 1 %.
std::string add_row(const std::string& name, double time, const StateRow& row, BodyTrack& track);

/// The trajectory in the folder of a run; what is no folder, as it is given.
std::filesystem::path trajectory_of(const std::filesystem::path& given);

/// Reads a trajectory, CSV or HDF5. A last line that was cut off is left out.
/// @throws InputError with the line at fault.
Trajectory read_trajectory(const std::filesystem::path& file);

}  // namespace app
