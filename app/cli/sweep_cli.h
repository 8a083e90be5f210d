#pragma once

#include "app/sweep/sweep.h"

namespace CLI {
class App;
}

namespace app {

/// Adds the command `sweep`, whose values are stored in `options`.
void add_sweep(CLI::App& program, SweepOptions& options);

}  // namespace app
