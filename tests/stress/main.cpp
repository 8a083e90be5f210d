#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "tests/stress/matrix.h"
#include "tests/stress/pool.h"
#include "tests/stress/results.h"

namespace {

namespace fs = std::filesystem;
using stress::Result;
using stress::RunName;

struct Options {
  std::optional<std::string> run;
  std::vector<std::string> filters;
  std::string part;
  std::string out;
  std::string also;
  std::string only;
  std::string program;
  std::size_t random = 0;
  unsigned seed = 1;
  int jobs = 2;
  bool subset = false, list = false, trace = false, fresh = false;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--run", options.run, "One run, by its name; parameters left out are at default");
  app.add_flag("--trace", options.trace, "With --run: time, energy and work of every step, as CSV");
  app.add_flag("--subset", options.subset, "About 200 runs instead of all");
  app.add_option("--random", options.random,
                 "N random runs of free bodies in place of the matrix (--seed)");
  app.add_option("--seed", options.seed, "Seed of --random; equal ones give equal runs [1]");
  app.add_option("--filter", options.filters,
                 "Runs whose name has this text, e.g. with=stack; several: that have all");
  app.add_option("--part", options.part, "K/N: of the runs only every N-th from the K-th (from 1)");
  app.add_flag("--list", options.list, "Prints the runs' names and does none");
  app.add_option("--jobs", options.jobs, "Runs at a time")->check(CLI::Range(1, 256));
  app.add_option("--out", options.out, "Folder of stress.csv; what it holds is not run again")
      ->take_last();
  app.add_option("--also", options.also, "File of more runs by their names, one a line");
  app.add_option("--only", options.only, "File of runs by their names in place of the matrix");
  app.add_flag("--fresh", options.fresh, "With --out: forgets what it holds");
}

bool chosen(const RunName& run, const Options& options) {
  const std::string name = run.text() + " ";
  return std::all_of(options.filters.begin(), options.filters.end(),
                     [&](const std::string& text) { return name.find(text) != std::string::npos; });
}

/// Returns the runs that a file lists, one per line; lines that start with # are comments.
std::vector<RunName> listed_runs(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::invalid_argument("cannot read " + file.string());
  std::vector<RunName> runs;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty() && line[0] != '#') runs.push_back(stress::parse_run(line));
  return runs;
}

std::vector<RunName> chosen_runs(const Options& options) {
  std::vector<RunName> runs = !options.only.empty() ? listed_runs(options.only)
                              : options.random > 0
                                  ? stress::random_runs(options.random, options.seed)
                              : options.subset ? stress::subset()
                                               : stress::whole_matrix();
  if (!options.also.empty())
    for (const RunName& run : listed_runs(options.also))
      if (std::find(runs.begin(), runs.end(), run) == runs.end()) runs.push_back(run);
  std::erase_if(runs, [&](const RunName& run) { return !chosen(run, options); });
  if (options.part.empty()) return runs;
  std::size_t first = 0, count = 0;
  char slash = 0;
  std::istringstream(options.part) >> first >> slash >> count;
  if (slash != '/' || first < 1 || first > count)
    throw std::invalid_argument("--part is K/N with 1 <= K <= N");
  std::vector<RunName> part;
  for (std::size_t i = first - 1; i < runs.size(); i += count) part.push_back(runs[i]);
  return part;
}

int do_one(const Options& options) {
  const RunName run = stress::parse_run(*options.run);
  if (options.trace) fmt::print("time,energy,rise,substeps,sweeps,z,vz\n");
  const stress::Outcome outcome = stress::run_through(
      run, [&](const engine::Simulation& simulation, const stress::Watch& watch) {
        if (!options.trace) return;
        const hydro::BodyState& state = simulation.states()[0];
        fmt::print("{},{},{},{},{},{},{}\n", simulation.time(), watch.energy(), watch.worst_rise(),
                   watch.most_substeps(), watch.most_sweeps(), state.position.z(),
                   state.linear_velocity.z());
      });
  fmt::print("{}\n", stress::table({{run, outcome}}));
  fmt::print("{}\n{}\n", stress::envelope_line({{run, outcome}}),
             outcome.fault.empty() ? "passed" : "FAILED " + outcome.fault);
  return outcome.fault.empty() ? 0 : 1;
}

/// Prints the progress as a line on a terminal.
void show_progress(std::size_t done, std::size_t all, std::size_t failed) {
  if (!::isatty(STDERR_FILENO)) return;
  fmt::print(stderr, "\r{} of {} runs, {} failed{}", done, all, failed, done == all ? "\n" : "");
}

std::vector<Result> do_runs(const std::vector<RunName>& runs, const Options& options) {
  std::optional<stress::ResultFile> file;
  if (options.fresh && !options.out.empty()) fs::remove(fs::path(options.out) / "stress.csv");
  if (!options.out.empty()) file.emplace(options.out, fs::read_symlink("/proc/self/exe"));
  std::vector<Result> results;
  std::vector<RunName> left;
  for (const RunName& run : runs) {
    const Result* known = nullptr;
    if (file)
      for (const Result& result : file->earlier())
        if (result.run == run) known = &result;
    known ? results.push_back(*known) : left.push_back(run);
  }
  std::size_t failed = 0;
  stress::do_all(left, options.jobs, [&](const RunName& run, const stress::Outcome& outcome) {
    results.push_back({run, outcome});
    if (file) file->add(results.back());
    failed += !outcome.fault.empty();
    show_progress(results.size(), runs.size(), failed);
  });
  return results;
}

int do_many(const Options& options) {
  const std::vector<RunName> runs = chosen_runs(options);
  if (runs.empty()) throw std::invalid_argument("no run has such a name");
  if (options.list) {
    for (const RunName& run : runs) fmt::print("{}\n", run.text());
    return 0;
  }
  const std::vector<Result> results = do_runs(runs, options);
  const std::string failed = stress::failures(results, options.program);
  fmt::print("{}\n{}\n{}", stress::table(results), stress::envelope_line(results), failed);
  return failed.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Short runs over extremes of every parameter, none of which may fail");
  Options options{.program = argv[0]};
  add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    return options.run ? do_one(options) : do_many(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
}
