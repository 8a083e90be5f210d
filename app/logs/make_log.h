#pragma once

#include <filesystem>
#include <memory>

#include "app/logs/log.h"

namespace app {

enum class LogFormat {
  csv,  ///< trajectory.csv and forces.csv; every row is in the file once it is added.
  hdf5  ///< run.h5; it is smaller, and faster to read, where there are many rows.
};

/// Opens the log of a run in its folder and removes the logs that an earlier run left there, in
/// either format. @throws InputError if the log cannot be written
std::unique_ptr<Log> make_log(LogFormat format, const LogSubject& subject,
                              const std::filesystem::path& folder);

}  // namespace app
