#pragma once

#include <functional>
#include <vector>

#include "tests/stress/outcome.h"

namespace stress {

/// Processor time after which a run is killed [s]. It ends steps that never end; the cost of other
/// steps is judged by their work (Watch).
inline constexpr unsigned kLongestRun = 600;

/// Called for every outcome, in the order in which runs end.
using Collector = std::function<void(const RunName&, const Outcome&)>;

/// Does each run in a process of its own, `jobs` at a time. A process that dies yields an outcome,
/// too.
void do_all(const std::vector<RunName>& runs, int jobs, const Collector& collect);

}  // namespace stress
