#pragma once

#include <nlohmann/json.hpp>

#include "app/compare/comparison.h"
#include "app/compare/comparison_report.h"

/// @file
/// What the page of a comparison shows, as the JSON that its script reads (web/differences.js).

namespace app {

/// What keeps a page of many bodies or long logs small: about 10 MB at most in all.
struct ComparisonLimits {
  std::size_t numbers = 1'500'000;  ///< In all columns of both logs and of the differences.
};

/// The verdict, the table of differences, and of each body the motion in either log, at its own
/// rows, and the differences over time.
nlohmann::ordered_json comparison_data(const Comparison& comparison, const ComparedFiles& files,
                                       const Trajectory& a, const Trajectory& b,
                                       const ComparisonLimits& limits = {});

}  // namespace app
