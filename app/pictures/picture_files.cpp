#include "app/pictures/picture_files.h"

#include <fmt/format.h>

#include <vector>

#include "app/logs/run_files.h"

namespace app {
namespace {

namespace fs = std::filesystem;

/// True for a picture whose name begins so, and for one that a killed run left in part
/// (render::write_png).
bool is_png(const fs::path& file, const char* begin) {
  return file.filename().string().starts_with(begin) &&
         (file.extension() == ".png" ||
          (file.stem().extension() == ".png" && file.extension().string().starts_with(".part-")));
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder)) entries.push_back(entry.path());
  return entries;
}

/// Removes the frames in a folder, and the folder if it is then empty.
void remove_frames(const fs::path& folder) {
  for (const fs::path& file : entries_of(folder))
    if (is_png(file, "frame_")) fs::remove(file);
  if (fs::is_directory(folder) && fs::is_empty(folder)) fs::remove(folder);
}

}  // namespace

fs::path frame_file(const fs::path& folder, const std::string& camera, std::size_t number) {
  return folder / kFramesFolder / camera / fmt::format("frame_{:04}.png", number);
}

fs::path sheet_file(const fs::path& folder, const std::string& camera) {
  return folder / (camera.empty() ? kSheetFile : fmt::format("sheet_{}.png", camera));
}

fs::path video_file(const fs::path& file, const std::string& camera) {
  if (camera.empty()) return file;
  return file.parent_path() /
         fmt::format("{}-{}{}", file.stem().string(), camera, file.extension().string());
}

void remove_pictures(const fs::path& folder) {
  for (const fs::path& file : entries_of(folder))
    if (is_png(file, "sheet_") || is_png(file, kSheetFile)) fs::remove(file);
  for (const fs::path& entry : entries_of(folder / kFramesFolder))
    if (fs::is_directory(entry) && !fs::is_symlink(entry)) remove_frames(entry);
  remove_frames(folder / kFramesFolder);
}

}  // namespace app
