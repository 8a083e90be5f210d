#include "app/compare/compare_folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "app/base/atomic_file.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/words.h"
#include "app/compare/chosen_tolerances.h"
#include "app/compare/comparison_report.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

/// The outcome of one run.
struct RunVerdict {
  std::string name;
  bool same = false;
  std::string text;   ///< In words, on one line.
  Json json;          ///< As for two runs.
  std::string junit;  ///< A test suite.
};

/// Returns how many times its tolerance a difference is.
double severity(const Difference& d) {
  const auto ratio = [](double found, double limit) { return found > 0 ? found / limit : 0; };
  return std::max(ratio(d.largest, d.peak_limit), ratio(d.rms, d.rms_limit));
}

/// Says what differs most between two runs, and how much else does.
std::string worst_of(const Comparison& comparison, const ComparedFiles& files) {
  std::string text;
  double worst = 0;
  std::size_t beyond = 0;
  const auto look_at = [&](const BodyComparison& body) {
    if (const std::string note = coverage(body, files); !note.empty() && text.empty())
      text = fmt::format("{} {}", body.name, note);
    for (const Difference& d : body.differences) {
      beyond += !d.within();
      if (d.within() || severity(d) <= worst) continue;
      worst = severity(d);
      text = fmt::format("{} {} by {:.4g} {} at {:g} s, tolerance {}", body.name, d.quantity,
                         d.largest, d.unit, d.when_largest, limits_text(d));
    }
  };
  std::ranges::for_each(comparison.bodies, look_at);
  for (const TableComparison& table : comparison.tables) {
    if (table.in != In::both && table.judged && text.empty())
      text = fmt::format("{} {}", table.name, only_in(table.in, files));
    for (const BodyComparison& name : table.names)
      if (name.judged) look_at(name);
  }
  return beyond > 1 ? fmt::format("{}, and {} more", text, beyond - 1) : text;
}

/// Returns how what made two runs differs, in brackets; empty if it does not or is not known.
std::string changes_text(const std::optional<Provenance>& provenance) {
  if (!provenance || provenance->alike()) return "";
  std::vector<std::string> parts;
  const auto add = [&](const std::vector<Change>& changes, const char* one, const char* many) {
    if (!changes.empty()) parts.push_back(counted(changes.size(), one, many));
  };
  add(provenance->programs, "program version", "program versions");
  add(provenance->keys, "scene key", "scene keys");
  add(provenance->meshes, "mesh", "meshes");
  return fmt::format(" (differ before: {})", enumerate(parts, "and"));
}

/// The verdict on a run that only one folder has or that cannot be read.
RunVerdict without_comparison(const std::string& name, const ComparedFiles& files,
                              const std::string& why) {
  return {.name = name,
          .text = why,
          .json = {{"same", false}, {"fault", why}},
          .junit = junit_suite_of_fault(name, why, files)};
}

RunVerdict compare_one(const std::string& name, const CompareOptions& options) {
  const auto a = options.a / name, b = options.b / name;
  const ComparedFiles files{.a = a.string(), .b = b.string()};
  try {
    const ComparedRun run_a = read_compared(a), run_b = read_compared(b);
    const Comparison comparison =
        compare_runs(run_a, run_b, chosen_tolerances(options, {a, b, options.a, options.b}));
    const std::optional<Provenance> provenance = provenance_of(run_a, run_b);
    const bool same = comparison.same();
    return {.name = name,
            .same = same,
            .text = verdict_text(comparison) + (same ? "" : ": " + worst_of(comparison, files)) +
                    changes_text(provenance),
            .json = json_of(comparison, files, provenance),
            .junit = junit_suite_of(comparison, files)};
  } catch (const scene::InputError& error) {
    return without_comparison(name, files, fmt::format("cannot be compared: {}", error.what()));
  }
}

std::vector<RunVerdict> compare_all(const CompareOptions& options,
                                    const std::vector<std::string>& runs_a,
                                    const std::vector<std::string>& runs_b) {
  std::vector<std::string> all;
  std::ranges::set_union(runs_a, runs_b, std::back_inserter(all));
  const ComparedFiles files{.a = options.a.string(), .b = options.b.string()};
  std::vector<RunVerdict> verdicts;
  for (const std::string& name : all) {
    const bool in_a = std::ranges::binary_search(runs_a, name);
    const bool in_b = std::ranges::binary_search(runs_b, name);
    verdicts.push_back(
        in_a && in_b
            ? compare_one(name, options)
            : without_comparison(name, files, only_in(in_a ? In::only_a : In::only_b, files)));
  }
  return verdicts;
}

void print_lines(const std::vector<RunVerdict>& verdicts, const ComparedFiles& files) {
  std::size_t width = 0, different = 0;
  for (const RunVerdict& verdict : verdicts) {
    width = std::max(width, verdict.name.size());
    different += !verdict.same;
  }
  print(fmt::format("{}\n", names_text(files)));
  for (const RunVerdict& verdict : verdicts)
    print(fmt::format("{:<{}}  {}\n", verdict.name, width, verdict.text));
  if (different == 0)
    print(fmt::format("{}: {}\n", counted(verdicts.size(), "run", "runs"), verdict_text(true)));
  else
    print(fmt::format("{} of {} different\n", different, counted(verdicts.size(), "run", "runs")));
}

}  // namespace

int compare_folders(const CompareOptions& options, const std::vector<std::string>& runs_a,
                    const std::vector<std::string>& runs_b) {
  const ComparedFiles files{.a = options.a.string(), .b = options.b.string()};
  const std::vector<RunVerdict> verdicts = compare_all(options, runs_a, runs_b);
  const bool same = std::ranges::all_of(verdicts, &RunVerdict::same);
  if (options.json) {
    Json json = {{"a", files.a}, {"b", files.b}, {"same", same}, {"runs", Json::object()}};
    for (const RunVerdict& verdict : verdicts) json["runs"][verdict.name] = verdict.json;
    print(fmt::format("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace)));
  } else {
    print_lines(verdicts, files);
  }
  std::vector<std::string> suites;
  for (const RunVerdict& verdict : verdicts) suites.push_back(verdict.junit);
  if (!options.junit.empty()) write_whole(options.junit, junit_file_of(suites));
  return same ? kDone : kDiffers;
}

}  // namespace app
