#pragma once

#include <filesystem>
#include <vector>

#include "app/scene/shape.h"

namespace app {

struct ReportOptions {
  /// Output folders of runs; of several, also trajectories.
  std::vector<std::filesystem::path> runs;
  std::filesystem::path out;    ///< The page; empty: report.html in the folder, or runs.html here.
  std::filesystem::path scene;  ///< Present path of the scene; empty: the path in the run.
  /// Formats of meshes that are read; a run that read any has its report do so, too.
  scene::MeshFormats formats = scene::MeshFormats::common;
};

/// Writes a page that needs no other file: about one run, or with the motions and loads of several
/// laid over each other. @return the exit code
/// @throws InputError, with the faults of all runs
int report(const ReportOptions& options);

}  // namespace app
