#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "app/pictures/shot_spool.h"
#include "app/pictures/video.h"
#include "app/render/renderer.h"
#include "app/scene/scene.h"

namespace app {

/// A video that was made.
struct VideoReport {
  std::filesystem::path file;
  int pictures = 0;
  int fps = 0;
};

/// How the pictures came about.
struct PictureReport {
  std::string device;                     ///< What drew them.
  int frames = 0;                         ///< In `frames/`, of all cameras.
  bool complete = false;                  ///< Not stopped before the last picture.
  double pressure_max = 0;                ///< Upper end of the colour scale [Pa].
  std::vector<std::string> cameras = {};  ///< Names, where there are several.
  std::vector<VideoReport> videos = {};
};

/// Where pictures go.
struct PictureTarget {
  std::filesystem::path folder;
  VideoOptions video;
};

/// Told after each picture; returns false to stop there.
using PictureProgress = std::function<bool(int done, int all)>;

/// Draws the shots by one camera after the other: frames and the figure of them all to the folder,
/// by the names of picture_files.h, and the video. Pictures of an earlier sequence are removed. A
/// video that is stopped has what was drawn; one that cannot be written is not there. Only for
/// scenes with a render block.
/// @throws render::Error, OutputError
PictureReport draw_pictures(const scene::Scene& scene, const assembly::BuiltScene& built,
                            const ShotSpool& shots, const PictureTarget& target,
                            const PictureProgress& progress);

/// What there is to say of the videos, a line each.
std::vector<std::string> videos_made(const PictureReport& report);

/// How a scene with a render block looks, but for the camera.
render::SceneDescription picture_of(const scene::Scene& scene, const engine::SimulationSpec& spec,
                                    const render::PressureScale& scale);

}  // namespace app
