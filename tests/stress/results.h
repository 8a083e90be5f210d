#pragma once

#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include "tests/stress/outcome.h"

/// @file
/// Outcomes of runs on disk and as tables.

namespace stress {

struct Result {
  RunName run;
  Outcome outcome;
};

/// `stress.csv` in a folder: a line a run, written as it ends, so that what an interruption leaves
/// is taken up by the next start. Lines of a program that has been built anew since are dropped.
class ResultFile {
 public:
  /// @param program   Whose results these are. @throws std::runtime_error if it cannot be written.
  ResultFile(const std::filesystem::path& folder, const std::filesystem::path& program);

  /// Results of earlier starts.
  const std::vector<Result>& earlier() const { return earlier_; }
  void add(const Result& result);

 private:
  std::vector<Result> earlier_;
  std::ofstream out_;
};

/// For every parameter and each of its values: runs, failures, worst rise of energy, most substeps
/// and solutions of a step.
std::string table(const std::vector<Result>& results);

/// Every failure, with the command that repeats it; empty if there is none.
std::string failures(const std::vector<Result>& results, const std::string& program);

}  // namespace stress
