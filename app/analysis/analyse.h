#pragma once

#include "app/analysis/analyse_options.h"

namespace app {

/// Prints statistics, spectra, decays and responses of a run. @return the exit code
int analyse(const AnalyseOptions& options);

}  // namespace app
