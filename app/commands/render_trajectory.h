#pragma once

#include <filesystem>
#include <vector>

#include "app/pictures/video.h"
#include "app/scene/reader.h"

namespace app {

struct RenderOptions {
  std::filesystem::path trajectory;
  std::filesystem::path scene;  ///< Empty: that of the run, from its summary.
  std::filesystem::path out;
  std::vector<scene::Override> overrides;
  scene::MeshFormats formats = scene::MeshFormats::common;  ///< Formats of meshes that are read.
  VideoOptions video;
  bool quiet = false;
};

/// Draws the same pictures of a logged trajectory as a run of its scene. @return the exit code
int render_trajectory(const RenderOptions& options);

}  // namespace app
