#include "app/pictures/video_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include "app/base/words.h"
#include "app/pictures/cameras.h"
#include "app/pictures/picture_files.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

namespace fs = std::filesystem;

const char* const kOption = "--video";

/// Browsers show pictures of a .gif that are shorter than 0.02 s for 0.1 s.
constexpr int kMostOfGif = 50;

void check_ending(const VideoOptions& video) {
  const std::string ending = video_ending(video.file);
  const std::vector<std::string> known = video_endings();
  if (std::find(known.begin(), known.end(), ending) == known.end())
    throw scene::InputError(kOption, fmt::format("found {}, expected a file that ends in {}",
                                                 video.file.string(), enumerate(known, "or")));
  if (ending == ".gif" && video.fps > kMostOfGif)
    throw scene::InputError("--fps",
                            fmt::format("found {}, expected at most {} for a .gif, of which more "
                                        "are shown slowly",
                                        video.fps, kMostOfGif));
}

void check_camera(const VideoOptions& video, const scene::Render& render) {
  if (video.camera.empty()) return;
  std::vector<std::string> names;
  for (const scene::Camera& camera : render.cameras) names.push_back(camera.name);
  if (std::find(names.begin(), names.end(), video.camera) != names.end()) return;
  throw scene::InputError(
      kOption, names.empty()
                   ? fmt::format("the scene's camera has no name, expected {} without {}=",
                                 video.file.string(), video.camera)
                   : fmt::format("there is no camera {}{}", video.camera,
                                 did_you_mean(video.camera, names)));
}

bool same_folder(const fs::path& a, const fs::path& b) {
  return fs::weakly_canonical(fs::absolute(a)) == fs::weakly_canonical(fs::absolute(b));
}

void check_folder(const fs::path& file, const fs::path& out) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code error;
  if (fs::is_directory(file, error))
    throw scene::InputError(kOption, fmt::format("{} is a folder, expected a file", file.string()));
  if (fs::is_directory(folder, error)) {
    try {
      const PartFile part(file);
    } catch (const std::runtime_error& fault) {
      throw scene::InputError(kOption, fault.what());
    }
  } else if (!same_folder(folder, out)) {
    throw scene::InputError(kOption, fmt::format("there is no folder {} for {}", folder.string(),
                                                 file.filename().string()));
  }
}

}  // namespace

VideoOptions video_options(const std::string& argument) {
  const std::size_t mark = argument.find('=');
  const std::string name = argument.substr(0, mark);
  if (mark == std::string::npos || !scene::is_camera_name(name)) return {.file = argument};
  return {.file = argument.substr(mark + 1), .camera = name};
}

std::optional<fs::path> video_by(const VideoOptions& video, const scene::Camera& camera,
                                 std::size_t cameras) {
  if (video.camera.empty()) return video_file(video.file, camera.name);
  if (cameras > 1 && camera.name != video.camera) return std::nullopt;
  return video.file;
}

void check_video(const VideoOptions& video, const scene::Render& render, const fs::path& out,
                 int threads) {
  if (!video.wanted()) return;
  check_ending(video);
  check_camera(video, render);
  const std::vector<scene::Camera> cameras = cameras_of(render);
  for (const scene::Camera& camera : cameras)
    if (const auto file = video_by(video, camera, cameras.size())) check_folder(*file, out);
  if (find_program("ffmpeg").empty())
    throw scene::InputError(
        kOption, "the program ffmpeg is not installed, which makes videos: apt-get install ffmpeg");
  const std::string fault = encoder_fault(
      video.file,
      {.width = render.size[0], .height = render.size[1], .fps = video.fps, .threads = threads});
  if (!fault.empty())
    throw scene::InputError(kOption,
                            fmt::format("ffmpeg cannot make {}: {}", video.file.string(), fault));
}

}  // namespace app
