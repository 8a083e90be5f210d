#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

/// @file
/// Files of the pictures of a run. `camera` is the name of one of several cameras, or empty if
/// there is only one.

namespace app {

/// FOLDER/frames/frame_0000.png or FOLDER/frames/CAMERA/frame_0000.png, numbered from 0.
std::filesystem::path frame_file(const std::filesystem::path& folder, const std::string& camera,
                                 std::size_t number);

/// FOLDER/sheet.png or FOLDER/sheet_CAMERA.png.
std::filesystem::path sheet_file(const std::filesystem::path& folder, const std::string& camera);

/// drop.mp4 or drop-CAMERA.mp4.
std::filesystem::path video_file(const std::filesystem::path& file, const std::string& camera);

/// Removes the frames and the sheets that an earlier run left in a folder.
void remove_pictures(const std::filesystem::path& folder);

}  // namespace app
