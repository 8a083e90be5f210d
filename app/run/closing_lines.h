#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/run/summary.h"

namespace app {

/// Returns what a run says at its end: how far it went and where its time went, what was solved
/// beforehand and in the steps, the largest errors of its constraints, and its pictures.
std::vector<std::string> closing_lines(const RunSummary& summary,
                                       const std::filesystem::path& folder);

}  // namespace app
