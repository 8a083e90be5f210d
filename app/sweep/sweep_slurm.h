#pragma once

#include <string>

#include "app/sweep/sweep_options.h"

namespace app {

/// Shell words: what is no plain word stands in quotes.
std::string shell_words(const std::vector<std::string>& words);

/// A script for Slurm. `bash SCRIPT` hands it in, with a job after it that writes the table;
/// `sbatch SCRIPT` hands in the runs alone. @param runs   At least one.
std::string slurm_script(const SweepOptions& options, std::size_t runs);

}  // namespace app
