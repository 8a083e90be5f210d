#pragma once

#include "app/compare/compare_options.h"
#include "app/compare/tolerances.h"

namespace app {

/// Returns the tolerances of a comparison: those of the command line, or else of the file that it
/// names, or else of tolerances.yaml in one of the folders, the first that has it.
/// @throws InputError
Tolerances chosen_tolerances(const CompareOptions& options,
                             const std::vector<std::filesystem::path>& folders);

}  // namespace app
