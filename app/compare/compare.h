#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace app {

/// Two trajectories, each a file or the folder of a run.
struct CompareOptions {
  std::filesystem::path a;
  std::filesystem::path b;
  /// Tolerances by quantity (`position`, …); only these quantities are judged. Empty: a file has
  /// them.
  std::map<std::string, double> tolerances;
  /// File of tolerances. Empty: tolerances.yaml in the folder of `a` or `b`, or else 1e-9 for all.
  std::filesystem::path tolerance_file;
  bool json = false;            ///< JSON is printed instead of a table.
  std::filesystem::path junit;  ///< Report for a CI server; empty: none.
  std::filesystem::path html;   ///< Page with plots, for a browser; empty: none.
};

/// Prints the differences of two trajectories. @return kDone, or kDiffers beyond tolerance
int compare(const CompareOptions& options);

}  // namespace app
