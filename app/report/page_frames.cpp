#include <algorithm>
#include <fstream>
#include <iterator>

#include "app/base/schedule.h"
#include "app/pages/packing.h"
#include "app/pictures/cameras.h"
#include "app/pictures/picture_files.h"
#include "app/report/page_data.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// Returns the frames from the first on, up to the first gap.
std::vector<fs::path> frame_files(const fs::path& folder, const std::string& camera) {
  std::vector<fs::path> files;
  for (;;) {
    const fs::path file = frame_file(folder, camera, files.size());
    if (!fs::is_regular_file(file)) return files;
    files.push_back(file);
  }
}

/// Returns the times of a run's pictures [s].
std::vector<double> frame_times(const scene::Scene& scene, std::size_t count) {
  std::vector<double> times;
  FrameSchedule frames(scene.render->every, scene.duration);
  const long steps = step_count(scene.duration, scene.step);
  for (long i = 0; i <= steps && times.size() < count; ++i) {
    const double time = static_cast<double>(i) * scene.step;
    if (frames.due(time)) times.push_back(time);
  }
  return times;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw scene::InputError(file, "cannot be read; expected a picture");
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

Json page_frames(const LoggedRun& run, const PageLimits& limits) {
  if (!run.scene.render) return nullptr;
  const std::vector<fs::path> files =
      frame_files(run.path, cameras_of(*run.scene.render).front().name);
  if (files.empty()) return nullptr;
  const std::vector<double> times = frame_times(run.scene, files.size());
  const std::size_t count = std::min(files.size(), times.size());
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < count; ++i) bytes += fs::file_size(files[i]);
  const std::size_t stride = std::max<std::size_t>((bytes + limits.frames - 1) / limits.frames, 1);
  Json shown_times = Json::array();
  Json images = Json::array();
  for (std::size_t i = 0; i < count; i += stride) {
    shown_times.push_back(times[i]);
    images.push_back(base64(bytes_of(files[i])));
  }
  return {{"times", shown_times}, {"images", images}, {"of", count}};
}

}  // namespace app
