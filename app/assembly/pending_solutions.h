#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/assembly/built_scene.h"

/// @file
/// Solutions that a run has to find before its first step, and the time that they take.

namespace assembly {

struct PendingSolution {
  std::string what;    ///< `radiation of hull`
  double seconds = 0;  ///< Its wall time [s].
};

/// Returns the solutions for a scene that its store lacks. Bodies that share one have it once.
/// @param built    Without added mass.
/// @param folder   The store's; none: nothing is stored.
std::vector<PendingSolution> pending_solutions(const scene::Scene& scene, const BuiltScene& built,
                                               const std::optional<std::filesystem::path>& folder,
                                               int threads);

/// Tells of the solutions and of their time in one line; empty where there is none.
std::string pending_text(const std::vector<PendingSolution>& pending);

}  // namespace assembly
