#pragma once

#include <filesystem>

#include "app/pictures/video.h"
#include "app/scene/scene.h"

namespace app {

/// Whether a video can be made, before anything is run for it: of its name, its folder, and of the
/// encoder, which is tried with one picture. Does nothing if none is wanted.
/// @param out   A folder that will be there.
/// @throws InputError
void check_video(const VideoOptions& video, const scene::Render& render,
                 const std::filesystem::path& out, int threads);

}  // namespace app
