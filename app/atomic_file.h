#pragma once

#include <filesystem>
#include <string_view>

namespace app {

/// Writes a file, and folders above it that are missing, so that it is there with all its bytes or
/// stays as it was, whatever happens meanwhile: a full disk, a cut of power, another process that
/// does the same. Parts of files with the same extension that a killed
/// process left behind a day ago or more are removed.
/// @throws std::runtime_error that names the file and says why it cannot be written
void write_whole(const std::filesystem::path& file, std::string_view bytes);

}  // namespace app
