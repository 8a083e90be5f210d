#pragma once

#include <filesystem>
#include <optional>

#include "app/logs/force_log.h"
#include "app/logs/table_log.h"
#include "app/logs/trajectory.h"

/// @file
/// The log of a run as HDF5 (hdf5_layout.h), read back.

namespace app {

/// True if the file starts as an HDF5 file does.
bool is_hdf5(const std::filesystem::path& file);

/// Reads the trajectory in a log, with one row per time of the log. @throws InputError
Trajectory read_hdf5_trajectory(const std::filesystem::path& file);

/// Reads the forces in a log, with one row per time; none if they were not logged. @throws
/// InputError
std::optional<ForceLog> read_hdf5_forces(const std::filesystem::path& file);

/// Reads a table in a log, with one row per time; none if the log does not have it.
/// @throws InputError
std::optional<TableRows> read_hdf5_table(const std::filesystem::path& file,
                                         const TableLayout& layout);

}  // namespace app
