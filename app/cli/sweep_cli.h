#pragma once

#include "app/sweep/sweep.h"

namespace CLI {
class App;
}

namespace app {

/// Adds the command `sweep` with its options, which are read into `options`.
void add_sweep(CLI::App& program, SweepOptions& options);

}  // namespace app
