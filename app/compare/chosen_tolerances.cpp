#include "app/compare/chosen_tolerances.h"

#include "app/logs/run_files.h"

namespace app {

Tolerances chosen_tolerances(const CompareOptions& options,
                             const std::vector<std::filesystem::path>& folders) {
  if (!options.tolerances.empty()) return parse_tolerances(options.tolerances);
  if (!options.tolerance_file.empty()) return read_tolerances(options.tolerance_file);
  for (const std::filesystem::path& folder : folders)
    if (const auto file = folder / kTolerancesFile; std::filesystem::exists(file))
      return read_tolerances(file);
  return {};
}

}  // namespace app
