#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace app {

/// Two runs, each a log or the folder of a run, or two folders of runs.
struct CompareOptions {
  std::filesystem::path a;
  std::filesystem::path b;
  std::vector<std::filesystem::path> more;  ///< Further runs to learn from.
  /// Tolerances, each `QUANTITY=NUMBER` (tolerances.h); only these quantities are judged. Empty: a
  /// file has them.
  std::vector<std::string> tolerances;
  /// File of tolerances. Empty: tolerances.yaml in the folder of `a` or `b`, or else the default.
  std::filesystem::path tolerance_file;
  bool json = false;            ///< JSON is printed instead of a table.
  std::filesystem::path junit;  ///< Report for a CI server; empty: none.
  std::filesystem::path html;   ///< Page with plots, for a browser; empty: none.
  std::filesystem::path learn;  ///< File of tolerances to be made from the runs; empty: none.
  double margin = 3;            ///< Learned tolerances over the differences of the runs.
};

}  // namespace app
