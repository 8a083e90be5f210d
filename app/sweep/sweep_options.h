#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

}  // namespace app
