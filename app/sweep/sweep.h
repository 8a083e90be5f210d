#pragma once

#include "app/sweep/sweep_options.h"

namespace app {

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

}  // namespace app
