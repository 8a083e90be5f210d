#pragma once

#include "app/sweep/sweep_options.h"

namespace app {

/// Runs a scene with all sets of values, each in a process of its own, and writes `sweep.csv`.
///
/// Runs that ended with exit code 0 or 3 (a state that is not finite) before are not repeated. Runs
/// that ended otherwise are repeated if this process does all runs. The number of simultaneous runs
/// is `jobs`; by default it is the number of cores, or one if the process is one of several ranks
/// (ranks.h).
///
/// @return kDone, kCannotGoOn if a run failed or is missing, kInterrupted
/// @throws InputError before anything runs
int sweep(const SweepOptions& options);

}  // namespace app
