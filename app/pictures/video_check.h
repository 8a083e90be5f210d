#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "app/pictures/video.h"
#include "app/scene/scene.h"

namespace app {

/// Reads the argument of `--video`: FILE, or CAMERA=FILE for the video of one camera. The text
/// before the first = is a camera's name if it can be one.
VideoOptions video_options(const std::string& argument);

/// Returns the file of the video that one of a scene's cameras makes; none if it makes none.
/// @param cameras   Number of cameras.
std::optional<std::filesystem::path> video_by(const VideoOptions& video,
                                              const scene::Camera& camera, std::size_t cameras);

/// Checks before a run that its video can be made: its camera, its name, its folder and the
/// encoder, which is tried with one picture. Does nothing if no video is wanted.
/// @param out   Output folder, which the run will create.
/// @throws InputError
void check_video(const VideoOptions& video, const scene::Render& render,
                 const std::filesystem::path& out, int threads);

}  // namespace app
