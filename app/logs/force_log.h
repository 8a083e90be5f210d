#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// @file
/// The log of forces, read back: CSV (force_writer.h) or HDF5 (hdf5_log.h).

namespace app {

/// The loads on one body over time.
struct ForceTrack {
  std::vector<double> times;                 ///< [s]
  std::vector<std::vector<double>> columns;  ///< In the order of force_columns().
};

using ForceLog = std::map<std::string, ForceTrack>;  ///< By the name of the body.

/// The forces in a log; none in an HDF5 log that has the motion alone.
/// @throws InputError with the line or row at fault.
std::optional<ForceLog> read_forces(const std::filesystem::path& file);

}  // namespace app
