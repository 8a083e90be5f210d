#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/scene/reader.h"
#include "app/sweep/sweep_parameters.h"

/// @file
/// Examination of the scenes of a sweep before any run is started.

namespace app {

/// Plan of a sweep: the scene, the overrides of all runs and the varied parameters.
struct SweepPlan {
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;
  std::vector<SweepParameter> parameters;
  std::vector<SweepPoint> points;                           ///< Values of each run.
  scene::MeshFormats formats = scene::MeshFormats::common;  ///< Formats of meshes that are read.

  /// Returns the overrides of one run.
  std::vector<scene::Override> overrides_of(std::size_t run) const;
};

struct SweepSurvey {
  std::vector<std::string> bodies;  ///< Names in all scenes, in the order of their appearance.
  /// Order of all runs. Runs that need a new solution of added mass come first, so that these are
  /// found in parallel.
  std::vector<std::size_t> order;
  std::set<std::filesystem::path> files;  ///< Meshes and height fields.
};

/// Reads the scene of every run. If only a combination of values is invalid, that run fails later
/// and the others are done.
/// @throws InputError if a value is invalid both alone and in every run, or if no scene can be
///     assembled
SweepSurvey survey(const SweepPlan& plan);

}  // namespace app
