#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/shape.h"

namespace app {

/// Options of a sweep: a scene is run many times with different values.
struct SweepOptions {
  std::filesystem::path scene;
  std::filesystem::path out;
  std::vector<std::string> sets;       ///< `KEY.PATH=VALUE`, in all runs.
  std::vector<std::string> varied;     ///< `KEY.PATH=VALUES`: see parse_sweep_parameter.
  std::optional<std::size_t> samples;  ///< Size of a Latin hypercube; none: all combinations.
  std::uint64_t seed = 1;              ///< Seed of the samples.
  int jobs = 0;                        ///< Runs at a time. 0: see sweep().
  bool fresh = false;                  ///< True: discard earlier results.
  bool slurm = false;                  ///< True: write a Slurm script, run nothing.
  bool gather = false;                 ///< True: write the table of finished runs, run nothing.
  std::optional<std::size_t> only;     ///< The only run to be done, without a table.
  scene::MeshFormats formats = scene::MeshFormats::common;  ///< Formats of meshes that are read.
  bool quiet = false;
};

}  // namespace app
