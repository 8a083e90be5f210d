#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace app {

/// True if a folder has the log of a run.
bool is_run_folder(const std::filesystem::path& folder);

/// Returns the run folders in a folder and its subfolders, down to three levels, as paths relative
/// to it, sorted; none if it is a run itself or no folder.
std::vector<std::string> runs_below(const std::filesystem::path& folder);

}  // namespace app
