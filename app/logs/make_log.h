#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "app/logs/log.h"

namespace app {

enum class LogFormat {
  csv,  ///< trajectory.csv, forces.csv and tables; a row is in the file once it is added.
  hdf5  ///< run.h5; a large log is smaller and faster to read.
};

/// Opens the log of a run in its folder. A new run removes the logs of an earlier one in either
/// format. A resumed run keeps its rows up to a position and drops those after it.
/// @throws InputError if the log cannot be written or ends before the position
std::unique_ptr<Log> make_log(LogFormat format, const LogSubject& subject,
                              const std::filesystem::path& folder,
                              const std::optional<LogPosition>& resumed = {});

}  // namespace app
