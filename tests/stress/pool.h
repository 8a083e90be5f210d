#pragma once

#include <functional>
#include <vector>

#include "tests/stress/outcome.h"

namespace stress {

/// Processor time after which a run is ended from outside [s]. What a step costs is judged by its
/// work (Watch); this is for a step that never ends.
inline constexpr unsigned kLongestRun = 600;

/// Told of every outcome as it comes, in the order in which runs end.
using Collector = std::function<void(const RunName&, const Outcome&)>;

/// Does each run in a process of its own, `jobs` at a time: one that dies is an outcome too.
void do_all(const std::vector<RunName>& runs, int jobs, const Collector& collect);

}  // namespace stress
