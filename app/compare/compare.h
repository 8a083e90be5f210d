#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace app {

/// Two trajectories, each a file or the folder of a run.
struct CompareOptions {
  std::filesystem::path a;
  std::filesystem::path b;
  /// By quantity (`position`, …); only those named are judged. Empty: those of a file.
  std::map<std::string, double> tolerances;
  /// Of tolerances. Empty: tolerances.yaml in the folder of `a` or of `b`, or else all to 1e-9.
  std::filesystem::path tolerance_file;
  bool json = false;            ///< JSON is printed, no table.
  std::filesystem::path junit;  ///< Report for a CI server; empty: none.
  std::filesystem::path html;   ///< Page with plots, for a browser; empty: none.
};

/// Prints how far two trajectories differ. @return kDone, or kDiffers beyond tolerance
int compare(const CompareOptions& options);

}  // namespace app
