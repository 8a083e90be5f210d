#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/logs/row_file.h"
#include "app/logs/trajectory.h"

/// @file
/// Trajectories as CSV: `time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz`, one row per body and time.

namespace app {

/// Writes a trajectory during a run. Rows are in the file when `add` returns.
class TrajectoryWriter {
 public:
  /// Replaces the file, or keeps its rows up to a position (row_file.h). @throws InputError
  TrajectoryWriter(const std::filesystem::path& file, std::vector<std::string> names,
                   const std::optional<FilePosition>& kept = {});

  /// Adds one row per body, in the order of the names, with digits that read back to the same
  /// numbers. @throws OutputError if the disk is full.
  void add(double time, const std::vector<hydro::BodyState>& states);

  /// See RowFile::save.
  FilePosition save() { return file_.save(); }
  /// See RowFile::check_place.
  void check_place() const { file_.check_place(); }

 private:
  std::vector<std::string> names_;
  RowFile file_;
  fmt::memory_buffer rows_;  ///< Rows of the last time; the buffer keeps its memory.
};

/// Reads a trajectory, which may have no rows. A last line without an end is dropped.
/// @throws InputError with the line at fault.
Trajectory read_trajectory_csv(const std::filesystem::path& file);

}  // namespace app
