#include "app/compare/compare.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <iterator>

#include "app/base/atomic_file.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/compare/chosen_tolerances.h"
#include "app/compare/compare_folders.h"
#include "app/compare/comparison.h"
#include "app/compare/comparison_data.h"
#include "app/compare/comparison_replay.h"
#include "app/compare/comparison_report.h"
#include "app/compare/learned_tolerances.h"
#include "app/compare/run_folders.h"
#include "app/pages/page_file.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

namespace fs = std::filesystem;

void print_comparison(const Comparison& comparison, const ComparedFiles& files,
                      const std::optional<Provenance>& provenance, bool json) {
  if (json) {
    const auto all = json_of(comparison, files, provenance);
    print(fmt::format("{}\n", all.dump(2, ' ', false, decltype(all)::error_handler_t::replace)));
    return;
  }
  print(names_text(files) + (provenance ? text_of(*provenance) : "") + "\n");
  // `print` would show the escapes of colours, too.
  std::fputs(table_of(comparison, files, in_color(STDOUT_FILENO)).c_str(), stdout);
}

int compare_two(const CompareOptions& options) {
  const std::string page = options.html.empty() ? "" : empty_page(kComparisonPage);
  const Tolerances tolerances = chosen_tolerances(options, {options.a, options.b});
  const ComparedFiles files{.a = options.a.string(), .b = options.b.string()};
  const ComparedRun a = read_compared(options.a);
  const ComparedRun b = read_compared(options.b);
  const Comparison comparison = compare_runs(a, b, tolerances);
  const std::optional<Provenance> provenance = provenance_of(a, b);
  print_comparison(comparison, files, provenance, options.json);
  if (!options.junit.empty())
    write_whole(options.junit, junit_file_of({junit_suite_of(comparison, files)}));
  if (!options.html.empty()) {
    const nlohmann::ordered_json replay = comparison_replay(options.a, options.b);
    say(write_page(
        options.html, page,
        comparison_data({comparison, files, provenance, a.trajectory, b.trajectory, replay})));
  }
  return comparison.same() ? kDone : kDiffers;
}

/// A run and the one that counts as equal to it.
struct LearnedPair {
  fs::path first;
  fs::path other;
};

/// Returns what tolerances are learned from: A with each other run, or each run in the folder A
/// with those of its name in the other folders. @throws InputError if one is missing
std::vector<LearnedPair> learned_pairs(const CompareOptions& options) {
  std::vector<fs::path> others = {options.b};
  others.insert(others.end(), options.more.begin(), options.more.end());
  const std::vector<std::string> names = runs_below(options.a);
  std::vector<LearnedPair> pairs;
  for (const fs::path& other : others) {
    const std::vector<std::string> found = runs_below(other);
    if (names.empty() && found.empty()) pairs.push_back({options.a, other});
    std::vector<std::string> missing;
    std::ranges::set_symmetric_difference(names, found, std::back_inserter(missing));
    if (!missing.empty())
      throw scene::InputError(
          other,
          fmt::format(
              "the run {} is only in {}, so no tolerance can be learned", missing.front(),
              (std::ranges::binary_search(names, missing.front()) ? options.a : other).string()));
    for (const std::string& name : names) pairs.push_back({options.a / name, other / name});
  }
  return pairs;
}

/// Writes the tolerances within which all runs agree with the first, or with those of their names
/// in the first folder.
int learn(const CompareOptions& options) {
  std::vector<Comparison> comparisons;
  std::vector<fs::path> runs;
  for (const LearnedPair& pair : learned_pairs(options)) {
    comparisons.push_back(compare_runs(read_compared(pair.first), read_compared(pair.other), {}));
    runs.push_back(pair.other);
  }
  const Tolerances tolerances = learned_tolerances(comparisons, options.margin, runs);
  std::string names = options.a.string() + ", " + options.b.string();
  for (const fs::path& run : options.more) names += ", " + run.string();
  // A line break in a name would end the comment.
  std::ranges::replace_if(
      names, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  write_whole(options.learn,
              fmt::format("# {:g} times the largest differences of {} from the first\n{}",
                          options.margin, names, yaml_of(tolerances)));
  const std::size_t given = 2 + options.more.size();
  const bool folders = !runs_below(options.a).empty();
  say(fmt::format("{}: {} from {}", options.learn.string(),
                  counted(tolerances.all.size(), "tolerance", "tolerances"),
                  folders ? fmt::format("{} of {} each", counted(given, "folder", "folders"),
                                        counted(runs.size() / (given - 1), "run", "runs"))
                          : counted(given, "run", "runs")));
  return kDone;
}

/// @throws InputError for options that do not go together
void check_options(const CompareOptions& options, bool folders) {
  if (options.learn.empty() && !options.more.empty())
    throw scene::InputError(options.more.front(),
                            "is a third run; expected two, or --learn FILE to learn from more");
  if (!folders) return;
  if (!options.html.empty())
    throw scene::InputError("--html", "found folders of runs, expected two runs for a page");
}

}  // namespace

int compare(const CompareOptions& options) {
  const std::vector<std::string> runs_a = runs_below(options.a);
  const std::vector<std::string> runs_b = runs_below(options.b);
  const bool folders = !runs_a.empty() && !runs_b.empty();
  check_options(options, folders);
  if (!folders && runs_a.size() + runs_b.size() > 0)
    throw scene::InputError(runs_b.empty() ? options.a : options.b,
                            fmt::format("holds runs and is none, while {} holds none; expected two "
                                        "runs, or two folders of runs",
                                        (runs_b.empty() ? options.b : options.a).string()));
  if (!options.learn.empty()) return learn(options);
  if (!folders) return compare_two(options);
  chosen_tolerances(options, {options.a, options.b});  // A fault in them is one, and not one a run.
  return compare_folders(options, runs_a, runs_b);
}

}  // namespace app
