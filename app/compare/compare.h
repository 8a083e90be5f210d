#pragma once

#include "app/compare/compare_options.h"

namespace app {

/// Prints the differences of two runs or folders of runs. @return kDone, or kDiffers beyond
/// tolerance
int compare(const CompareOptions& options);

}  // namespace app
