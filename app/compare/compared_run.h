#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "app/logs/table_log.h"
#include "app/logs/trajectory.h"

namespace app {

/// Part of a run that a comparison reads.
struct ComparedRun {
  Trajectory trajectory;
  std::map<std::string, TableRows> tables;  ///< By their names (quantities.h); those that it has.
  nlohmann::ordered_json summary;           ///< Null if there is none.
};

/// Reads a run.
/// @param path   Its folder, of which all is read; or a log: of CSV the trajectory alone is read,
///     of HDF5 all tables in it. @throws InputError
ComparedRun read_compared(const std::filesystem::path& path);

}  // namespace app
