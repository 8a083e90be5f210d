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
  std::filesystem::path resume;  ///< Folder of a run to go on with; empty: a new one.
  bool render = true;
  VideoOptions video;
  int threads = 0;  ///< 0: as many as the machine has.
  bool quiet = false;
};

/// Runs a scene to its end, from its start or from the last checkpoint of a run that was stopped,
/// and writes its log, its summary and its pictures. A run that was resumed writes the same rows
/// and pictures as one that was not stopped.
/// @return kDone; kCannotGoOn for a state that is not finite; kInterrupted; kWrongInput if a result
///     could not be written
/// @throws InputError before the first step
int run(const RunOptions& options);

}  // namespace app
