#pragma once

#include <filesystem>
#include <vector>

#include "app/scene/reader.h"

namespace app {

struct ViewOptions {
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;
  scene::MeshFormats formats = scene::MeshFormats::common;  ///< Formats of meshes that are read.
  int threads = 0;                                          ///< Number of threads; 0: one per core.
  std::filesystem::path snapshot;  ///< File for the picture at `after`; empty: none.
  double after = 0;                ///< Simulated time [s].
};

/// Plays a scene in a window, in real time, until the window is closed or the snapshot is taken.
/// @return the exit code
int view(const ViewOptions& options);

}  // namespace app
