#include "app/compare/compare.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "app/base/atomic_file.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/words.h"
#include "app/compare/comparison.h"
#include "app/compare/comparison_data.h"
#include "app/compare/comparison_report.h"
#include "app/logs/read_log.h"
#include "app/logs/run_files.h"
#include "app/pages/page_file.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

void check_quantities(const std::map<std::string, double>& tolerances) {
  std::vector<std::string> known;
  for (const ComparedQuantity& q : kComparedQuantities) known.emplace_back(q.name);
  for (const auto& [name, value] : tolerances) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw scene::InputError(
          "--tol", fmt::format("unknown quantity {}; there are {}", name, enumerate(known, "and")));
    if (!(value >= 0))
      throw scene::InputError("--tol",
                              fmt::format("{}={}: expected a number not below 0", name, value));
  }
}

Tolerances tolerances_of(const CompareOptions& options) {
  check_quantities(options.tolerances);
  if (!options.tolerances.empty()) return {.all = options.tolerances, .bodies = {}};
  if (!options.tolerance_file.empty()) return read_tolerances(options.tolerance_file);
  for (const std::filesystem::path& folder : {options.a, options.b})
    if (const auto file = folder / kTolerancesFile; std::filesystem::exists(file))
      return read_tolerances(file);
  return {};
}

/// True if the output is a terminal and NO_COLOR is not set.
bool in_color() { return ::isatty(STDOUT_FILENO) && std::getenv("NO_COLOR") == nullptr; }

}  // namespace

int compare(const CompareOptions& options) {
  const std::string page = options.html.empty() ? "" : empty_page(kComparisonPage);
  const Tolerances tolerances = tolerances_of(options);
  const ComparedFiles files{.a = options.a.string(), .b = options.b.string()};
  const Trajectory a = read_trajectory(trajectory_of(options.a));
  const Trajectory b = read_trajectory(trajectory_of(options.b));
  const Comparison comparison = compare_trajectories(a, b, tolerances);
  if (options.json)
    fmt::print("{}", json_of(comparison, files));
  else
    fmt::print("{}", table_of(comparison, files, in_color()));
  if (!options.junit.empty()) write_whole(options.junit, junit_of(comparison, files));
  if (!options.html.empty())
    say(write_page(options.html, page, comparison_data(comparison, files, a, b)));
  return comparison.same() ? kDone : kDiffers;
}

}  // namespace app
