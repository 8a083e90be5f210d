#pragma once

#include <filesystem>
#include <optional>

#include "app/logs/force_log.h"
#include "app/logs/table_log.h"
#include "app/logs/trajectory.h"

/// @file
/// Reader of the logs of a run, CSV or HDF5.

namespace app {

/// Returns the trajectory in the folder of a run; a path that is no folder is returned unchanged.
std::filesystem::path trajectory_of(const std::filesystem::path& given);

/// Reads a trajectory of at least one row. @throws InputError with the line or row at fault.
Trajectory read_trajectory(const std::filesystem::path& file);

/// Returns the log that has the forces of a trajectory, of which an HDF5 log may have none; empty
/// if there is none.
std::filesystem::path forces_beside(const std::filesystem::path& trajectory);

/// Reads the forces in a log; an HDF5 log may have none.
/// @throws InputError with the line or row at fault.
std::optional<ForceLog> read_forces(const std::filesystem::path& file);

/// Reads a table of a run: its file beside the trajectory, or its datasets in an HDF5 log; none if
/// the run has no such table. @throws InputError with the line or row at fault.
std::optional<TableRows> read_table(const std::filesystem::path& trajectory,
                                    const TableLayout& layout);

}  // namespace app
