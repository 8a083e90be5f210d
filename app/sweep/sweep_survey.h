#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/scene/reader.h"
#include "app/sweep/sweep_parameters.h"

/// @file
/// What a sweep learns of its runs from their scenes before any of them is started.

namespace app {

/// A sweep: a scene, what is set in all runs, and what is varied.
struct SweepPlan {
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;
  std::vector<SweepParameter> parameters;
  std::vector<SweepPoint> points;  ///< A run each.

  /// Of one run.
  std::vector<scene::Override> overrides_of(std::size_t run) const;
};

struct SweepSurvey {
  std::vector<std::string> bodies;  ///< Names in all scenes, in the order of their appearance.
  /// All runs, first those with a body whose added mass no earlier one needs: these can be solved
  /// for side by side.
  std::vector<std::size_t> order;
  std::set<std::filesystem::path> files;  ///< Meshes and height fields.
};

/// Reads the scene of every run. A combination of values that are each right elsewhere may be
/// wrong: that run fails when it is done, and the others are done.
/// @throws InputError if a value is wrong both by itself and in every run, or if no scene can be
///     assembled
SweepSurvey survey(const SweepPlan& plan);

}  // namespace app
