#include "tests/stress/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace stress {
namespace {

namespace fs = std::filesystem;

/// Returns a text that differs between two builds of a program.
std::string build_mark(const fs::path& program) {
  return fmt::format("# {} bytes, built at {}", fs::file_size(program),
                     fs::last_write_time(program).time_since_epoch().count());
}

std::vector<Result> read_results(const fs::path& file, const std::string& mark) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line) || line != mark) return {};
  std::getline(in, line);  // the columns
  std::vector<Result> results;
  while (std::getline(in, line)) {
    if (in.eof()) break;  // interrupted in the middle of a line
    const std::size_t comma = line.find(',');
    results.push_back({parse_run(line.substr(0, comma)), outcome_from_csv(line.substr(comma + 1))});
  }
  return results;
}

/// Line of the table for the runs with one value of a parameter.
struct Line {
  long runs = 0, inside = 0, failed = 0, judged = 0;
  double rise = 0;
  long substeps = 0, sweeps = 0;
  long unconverged = 0, clamped = 0;

  void add(const Outcome& outcome) {
    ++runs;
    inside += outcome.inside;
    failed += !outcome.fault.empty();
    judged += outcome.judged;
    rise = std::max(rise, outcome.rise);
    substeps = std::max(substeps, outcome.substeps);
    sweeps = std::max(sweeps, outcome.sweeps);
    unconverged += outcome.unconverged > 0;
    clamped += outcome.clamped > 0;
  }
  std::string text(const std::string& key, const std::string& value) const {
    return fmt::format(
        "| {:8} | {:10} | {:5} | {:6} | {:6} | {:6} | {:10.2e} | {:8} | {:9} | {:11} | {:7} |\n",
        key, value, runs, inside, failed, judged, rise, substeps, sweeps, unconverged, clamped);
  }
};

/// Returns the values of a parameter in the order of the matrix, followed by other values that were
/// run.
std::vector<std::string> values_of(const Dimension& dimension, const std::vector<Result>& results) {
  std::vector<std::string> values = dimension.values;
  for (const Result& result : results)
    if (std::find(values.begin(), values.end(), result.run[dimension.key]) == values.end())
      values.push_back(result.run[dimension.key]);
  return values;
}

}  // namespace

ResultFile::ResultFile(const fs::path& folder, const fs::path& program) {
  fs::create_directories(folder);
  const fs::path file = folder / "stress.csv";
  const std::string mark = build_mark(program);
  earlier_ = read_results(file, mark);
  out_.open(file);
  out_ << mark << "\nrun," << kOutcomeColumns << '\n';
  for (const Result& result : earlier_)
    out_ << result.run.text() << ',' << to_csv(result.outcome) << '\n';
  out_.flush();
  if (!out_) throw std::runtime_error(fmt::format("{} cannot be written", file.string()));
}

void ResultFile::add(const Result& result) {
  out_ << result.run.text() << ',' << to_csv(result.outcome) << '\n';
  out_.flush();
  if (!out_) throw std::runtime_error("a result cannot be written");
}

std::string table(const std::vector<Result>& results) {
  std::string text =
      "|          | value      |  runs | inside | failed | judged | worst rise | substeps |    "
      "sweeps | "
      "unconverged | clamped |\n"
      "| -------- | ---------- | ----: | -----: | -----: | -----: | ---------: | -------: | "
      "--------: | "
      "----------: | ------: |\n";
  Line all;
  for (const Dimension& dimension : dimensions()) {
    for (const std::string& value : values_of(dimension, results)) {
      Line line;
      for (const Result& result : results)
        if (result.run[dimension.key] == value) line.add(result.outcome);
      if (line.runs > 0) text += line.text(dimension.name, value);
    }
  }
  for (const Result& result : results) all.add(result.outcome);
  return text + all.text("all", "");
}

std::string envelope_line(const std::vector<Result>& results) {
  long runs[2] = {}, failed[2] = {}, stopped = 0;
  for (const Result& result : results) {
    ++runs[result.outcome.inside];
    failed[result.outcome.inside] += !result.outcome.fault.empty();
    stopped += result.outcome.stopped;
  }
  return fmt::format(
      "inside the operating envelope: {} runs, {} failed; outside: {} runs, {} failed, {} stopped",
      runs[1], failed[1], runs[0], failed[0], stopped);
}

std::string failures(const std::vector<Result>& results, const std::string& program) {
  std::string text;
  for (const Result& result : results)
    if (!result.outcome.fault.empty())
      text += fmt::format("FAILED {}\n  {} --run '{}'\n", result.outcome.fault, program,
                          result.run.text());
  return text;
}

}  // namespace stress
