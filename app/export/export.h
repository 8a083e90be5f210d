#pragma once

#include <filesystem>
#include <vector>

#include "app/export/animated_scene.h"
#include "app/scene/reader.h"

namespace app {

struct ExportOptions {
  std::filesystem::path run;    ///< Folder of the run, or its trajectory.
  std::filesystem::path out;    ///< File `.glb`.
  std::filesystem::path scene;  ///< Empty: that of the run, from its summary.
  std::vector<scene::Override> overrides;
  scene::MeshFormats formats = scene::MeshFormats::common;  ///< Formats of meshes that are read.
  int fps = 25;                                             ///< Poses per second.
  AnimationOptions animation;
  bool quiet = false;
};

/// Writes a logged run as an animated scene for other programs. @return the exit code
int export_run(const ExportOptions& options);

}  // namespace app
