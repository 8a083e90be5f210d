#include "app/compare/run_folders.h"

#include <algorithm>
#include <system_error>

#include "app/logs/run_files.h"
#include "app/scene/diagnostics.h"

namespace app {

namespace fs = std::filesystem;

bool is_run_folder(const fs::path& folder) {
  return fs::is_directory(folder) &&
         (fs::exists(folder / kTrajectoryLog) || fs::exists(folder / kHdf5Log));
}

std::vector<std::string> runs_below(const fs::path& folder) {
  constexpr int kMostLevels = 3;
  std::vector<std::string> runs;
  if (!fs::is_directory(folder) || is_run_folder(folder)) return runs;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    const bool run = is_run_folder(entry->path());
    if (run) runs.push_back(entry->path().lexically_relative(folder).string());
    if (run || entry.depth() + 1 >= kMostLevels) entry.disable_recursion_pending();
  }
  if (error) throw scene::InputError(folder, "cannot be read: " + error.message());
  std::ranges::sort(runs);
  return runs;
}

}  // namespace app
