#pragma once

#include <nlohmann/json.hpp>

#include "app/compare/comparison.h"
#include "app/compare/comparison_report.h"

/// @file
/// Data of the page of a comparison, as the JSON that its script reads (web/differences.js).

namespace app {

/// Limit that keeps a page of many bodies or long logs below about 10 MB.
struct ComparisonLimits {
  std::size_t numbers = 1'500'000;  ///< Numbers in all columns of both logs and of the differences.
};

/// Returns the verdict, the table of differences, and for each body the motion in either log, at
/// the log's own rows, and the differences over time.
nlohmann::ordered_json comparison_data(const Comparison& comparison, const ComparedFiles& files,
                                       const Trajectory& a, const Trajectory& b,
                                       const ComparisonLimits& limits = {});

}  // namespace app
