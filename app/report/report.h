#pragma once

#include <filesystem>

namespace app {

struct ReportOptions {
  std::filesystem::path folder;  ///< Of a run.
  std::filesystem::path scene;   ///< Where the scene lies now; empty: where it was run.
};

/// Writes FOLDER/report.html: the run in one page that needs no other file. @return the exit code
int report(const ReportOptions& options);

}  // namespace app
