#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/logs/force_log.h"
#include "app/logs/trajectory.h"

/// @file
/// Data of the page of several runs, as the JSON that its script reads (web/runs.js). SI units;
/// angles in degrees.

namespace app {

/// The logs of a run that the page shows.
struct PageRun {
  std::string name;  ///< As the user gave it.
  Trajectory trajectory;
  std::optional<ForceLog> forces;  ///< None if forces were not logged.
};

/// Limit that keeps a page of many bodies or long logs below about 10 MB.
struct RunsLimits {
  std::size_t numbers = 1'500'000;  ///< Numbers in all columns.
};

/// @param path   Folder of a run, or a trajectory.
/// @throws InputError if there is no log or it is damaged
PageRun read_page_run(const std::filesystem::path& path);

/// Returns the names of the runs, and for each body that one has its motion and its loads in each,
/// null where a run lacks them, at the log's own rows.
nlohmann::ordered_json runs_data(const std::vector<PageRun>& runs, const RunsLimits& limits = {});

}  // namespace app
