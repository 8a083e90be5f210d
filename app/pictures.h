#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/assemble.h"
#include "app/render/renderer.h"
#include "app/scene/scene.h"
#include "app/shot.h"

namespace app {

/// How the pictures came about.
struct PictureReport {
  std::string device;  ///< What drew them.
  int frames = 0;
  double pressure_max = 0;  ///< Upper end of the colour scale [Pa].
};

/// Told after each picture; returns false to stop there.
using PictureProgress = std::function<bool(int done, int all)>;

/// Draws each shot to FOLDER/frames/frame_0000.png… and all of them to FOLDER/sheet.png. Frames of
/// an earlier sequence are removed. Only for scenes with a render block.
/// @throws render::Error
PictureReport draw_pictures(const Scene& scene, const Assembly& assembly,
                            const std::vector<Shot>& shots, const std::filesystem::path& folder,
                            const PictureProgress& progress);

/// How a scene with a render block looks.
render::Picture picture_of(const Scene& scene, const engine::SimulationSpec& spec,
                           const render::PressureScale& scale);

/// Where the picture of that number lies, from 0.
std::filesystem::path frame_file(const std::filesystem::path& folder, std::size_t number);

/// Removes the frames and the sheet that an earlier run left in a folder.
void remove_pictures(const std::filesystem::path& folder);

}  // namespace app
