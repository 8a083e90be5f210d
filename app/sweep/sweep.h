#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace app {

/// A scene run many times with other values.
struct SweepOptions {
  std::filesystem::path scene;
  std::filesystem::path out;
  std::vector<std::string> sets;       ///< `KEY.PATH=VALUE`, in all runs.
  std::vector<std::string> varied;     ///< `KEY.PATH=VALUES`: see parse_sweep_parameter.
  std::optional<std::size_t> samples;  ///< Of a Latin hypercube; none: all combinations.
  std::uint64_t seed = 1;              ///< Of the samples.
  int jobs = 0;                        ///< Runs at a time. 0: see sweep().
  bool fresh = false;                  ///< Do anew what was done.
  bool slurm = false;                  ///< Write a script for Slurm, run nothing.
  bool gather = false;                 ///< Write the table of what was done, run nothing.
  std::optional<std::size_t> only;     ///< Do this run, and write no table.
  bool quiet = false;
};

/// Runs a scene with all values, each run in a process of its own, and writes `sweep.csv`.
///
/// What is done already is not done again: runs that ended by themselves, well (0) or in a state
/// that is not finite (3). What ended otherwise is tried anew where this process does all runs.
/// So many runs go on at a time as the machine has cores; where the process is one of several ranks
/// (ranks.h) one, unless `jobs` says otherwise.
///
/// @return kDone, kCannotGoOn if a run failed or is missing, kInterrupted
/// @throws InputError before anything runs
int sweep(const SweepOptions& options);

/// The command and its options.
void add_sweep(CLI::App& program, SweepOptions& options);

}  // namespace app
