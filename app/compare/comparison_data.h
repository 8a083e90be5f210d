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

/// Content of a page.
struct ComparedPage {
  const Comparison& comparison;
  const ComparedFiles& files;
  const std::optional<Provenance>& provenance;
  const Trajectory& a;
  const Trajectory& b;
  const nlohmann::ordered_json& replay;  ///< Replay of both (comparison_replay.h).
};

/// Returns the verdict, what made the runs differ, the table of differences, for each body the
/// motion in either log, at the log's own rows, and the differences over time, the verdicts on
/// tables, and the replay.
nlohmann::ordered_json comparison_data(const ComparedPage& page,
                                       const ComparisonLimits& limits = {});

}  // namespace app
