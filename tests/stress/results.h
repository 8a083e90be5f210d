#pragma once

#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include "tests/stress/outcome.h"

/// @file
/// Storage and tables of the outcomes of runs.

namespace stress {

struct Result {
  RunName run;
  Outcome outcome;
};

/// `stress.csv` in a folder. Each run adds a line when it ends, so that the next start resumes
/// after an interruption. Lines of an older build of the program are dropped.
class ResultFile {
 public:
  /// @param program   Program that makes the results. @throws std::runtime_error if it cannot be
  ///     written.
  ResultFile(const std::filesystem::path& folder, const std::filesystem::path& program);

  /// Returns the results of earlier starts.
  const std::vector<Result>& earlier() const { return earlier_; }
  void add(const Result& result);

 private:
  std::vector<Result> earlier_;
  std::ofstream out_;
};

/// Returns for each value of each parameter: number of runs, of those inside the envelope, and of
/// failures, largest rise of energy, largest numbers of substeps and sweeps in a step.
std::string table(const std::vector<Result>& results);

/// Returns in a line how many runs lay inside the operating envelope and outside it, and how many
/// of each failed or, outside, stopped.
std::string envelope_line(const std::vector<Result>& results);

/// Returns every failure with the command that repeats it; empty if there is none.
std::string failures(const std::vector<Result>& results, const std::string& program);

}  // namespace stress
