#pragma once

#include <filesystem>
#include <vector>

#include "app/logs/make_log.h"
#include "app/pictures/video.h"
#include "app/scene/reader.h"

namespace app {

struct RunOptions {
  std::filesystem::path scene;
  std::filesystem::path out;  ///< Empty: out/<scene file's stem>.
  std::vector<scene::Override> overrides;
  LogFormat format = LogFormat::csv;
  double checkpoint = 0;         ///< Wall time between two checkpoints [s]; 0: there are none.
  std::filesystem::path resume;  ///< Folder of a run to resume; empty: a new run.
  scene::MeshFormats formats = scene::MeshFormats::common;  ///< Formats of meshes that are read.
  bool render = true;
  VideoOptions video;
  int threads = 0;  ///< 0: all hardware threads.
  bool quiet = false;
};

/// Runs a scene from its start, or from the last checkpoint of a stopped run, to its end, and
/// writes the log, summary and pictures. A resumed run writes the same rows and pictures as an
/// uninterrupted one.
/// @return kDone; kCannotGoOn for a state that is not finite; kInterrupted; kWrongInput if a result
///     could not be written
/// @throws InputError before the first step
int run(const RunOptions& options);

}  // namespace app
