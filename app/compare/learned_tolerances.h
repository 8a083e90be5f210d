#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/compare/comparison.h"

namespace app {

/// Returns the tolerances within which all comparisons agree: of each quantity its largest
/// difference and its root mean square, times the margin and rounded up to two digits. A name whose
/// differences are below a tenth of the largest of all names has tolerances of its own. None is
/// below Tolerances::kDefault, of tables that times one and the size of the quantity.
/// @param runs   The names of B of each comparison, for faults.
/// @throws InputError if one run lacks a body, a table, rows or numbers that another has
Tolerances learned_tolerances(const std::vector<Comparison>& comparisons, double margin,
                              const std::vector<std::filesystem::path>& runs);

}  // namespace app
