#pragma once

#include <filesystem>

#include "app/pictures/video.h"
#include "app/scene/scene.h"

namespace app {

/// Checks before a run that its video can be made: its name, its folder and the encoder, which is
/// tried with one picture. Does nothing if no video is wanted.
/// @param out   Output folder, which the run will create.
/// @throws InputError
void check_video(const VideoOptions& video, const scene::Render& render,
                 const std::filesystem::path& out, int threads);

}  // namespace app
