#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "app/pictures/shot_spool.h"
#include "app/pictures/video.h"
#include "app/render/renderer.h"
#include "app/scene/scene.h"

namespace app {

struct Paints;

/// A video that was made.
struct VideoReport {
  std::filesystem::path file;
  int pictures = 0;
  int fps = 0;
};

/// Account of the pictures that were drawn.
struct PictureReport {
  std::string device;     ///< Graphics device.
  int frames = 0;         ///< Number of pictures in `frames/`, of all cameras.
  bool complete = false;  ///< True: the last picture was drawn.
  std::optional<double> pressure_max =
      {};                                 ///< Upper end of the colour scale [Pa], if there is one.
  std::vector<std::string> cameras = {};  ///< Names, if there are several.
  std::vector<VideoReport> videos = {};
  std::vector<std::string> warnings = {};  ///< Of textures that cannot be read.
};

/// Files to which pictures are written.
struct PictureTarget {
  std::filesystem::path folder;
  VideoOptions video;
};

/// Called after each picture; returns false to stop drawing.
using PictureProgress = std::function<bool(int done, int all)>;

/// Draws the shots by one camera after the other and writes frames, contact sheet and video to the
/// files of picture_files.h. Pictures of an earlier sequence are removed. A stopped video holds the
/// pictures drawn so far; a video that cannot be written leaves no file. The scene must have a
/// render block.
/// @throws render::Error, OutputError
PictureReport draw_pictures(const scene::Scene& scene, const assembly::BuiltScene& built,
                            const ShotSpool& shots, const PictureTarget& target,
                            const PictureProgress& progress);

/// True if pictures of a scene have the colours of pressures.
bool shows_pressures(const scene::Render& look, const engine::SimulationSpec& spec);

/// Returns one line of text for each video.
std::vector<std::string> videos_made(const PictureReport& report);

/// Returns the render settings of a scene with a render block, without the camera.
/// @param paints   The colours of mesh files (paints.h).
render::SceneDescription picture_of(const scene::Scene& scene, const assembly::BuiltScene& built,
                                    const render::PressureScale& scale, const Paints& paints);

}  // namespace app
