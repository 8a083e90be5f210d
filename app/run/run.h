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
  bool render = true;
  VideoOptions video;
  int threads = 0;  ///< 0: as many as the machine has.
  bool quiet = false;
};

/// Runs a scene to its end and writes its log, its summary and its pictures.
/// @return kDone; kCannotGoOn for a state that is not finite; kInterrupted; kWrongInput if a result
///     could not be written
/// @throws InputError before the first step
int run(const RunOptions& options);

}  // namespace app
