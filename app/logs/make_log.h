#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "app/logs/log.h"

namespace app {

enum class LogFormat {
  csv,  ///< trajectory.csv and forces.csv; every row is in the file once it is added.
  hdf5  ///< run.h5; it is smaller, and faster to read, where there are many rows.
};

/// Opens the log of a run in its folder. A new run removes the logs that an earlier one left there,
/// in either format; a resumed one keeps the rows of its own up to a position, and drops those
/// after it.
/// @throws InputError if the log cannot be written, or does not reach to the position
std::unique_ptr<Log> make_log(LogFormat format, const LogSubject& subject,
                              const std::filesystem::path& folder,
                              const std::optional<LogPosition>& resumed = {});

}  // namespace app
