#pragma once

#include <string>

#include "app/sweep/sweep_options.h"

namespace app {

/// Returns words for a shell, with quotes around those that need them.
std::string shell_words(const std::vector<std::string>& words);

/// Returns a script for Slurm. `bash SCRIPT` submits the runs and a subsequent job that writes the
/// table; `sbatch SCRIPT` submits the runs alone. @param runs   Number of runs, >= 1.
std::string slurm_script(const SweepOptions& options, std::size_t runs);

}  // namespace app
