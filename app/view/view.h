#pragma once

#include <filesystem>
#include <vector>

#include "app/scene/reader.h"

namespace app {

struct ViewOptions {
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;
  int threads = 0;                 ///< 0: as many as the machine has.
  std::filesystem::path snapshot;  ///< Of what the window shows `after` so long; empty: none.
  double after = 0;                ///< Simulated [s].
};

/// Plays a scene in a window, in real time, until that is closed or the snapshot is taken.
/// @return the exit code
int view(const ViewOptions& options);

}  // namespace app
