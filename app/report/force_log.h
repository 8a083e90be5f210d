#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// @file
/// The log of forces (force_writer.h), read back.

namespace app {

/// The loads on one body over time.
struct ForceTrack {
  std::vector<double> times;                 ///< [s]
  std::vector<std::vector<double>> columns;  ///< In the order of force_columns().
};

using ForceLog = std::map<std::string, ForceTrack>;  ///< By the name of the body.

/// @throws InputError with the line at fault.
ForceLog read_forces(const std::filesystem::path& file);

}  // namespace app
