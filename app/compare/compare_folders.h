#pragma once

#include <string>
#include <vector>

#include "app/compare/compare_options.h"

namespace app {

/// Compares each run below A with that of the same name below B, and prints a line for each.
/// @param runs_a   Result of runs_below(options.a); likewise `runs_b`.
/// @return kDone, or kDiffers if any differs, is missing on one side or cannot be read
int compare_folders(const CompareOptions& options, const std::vector<std::string>& runs_a,
                    const std::vector<std::string>& runs_b);

}  // namespace app
