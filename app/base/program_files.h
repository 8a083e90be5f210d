#pragma once

#include <filesystem>
#include <string>

namespace app {

/// A folder that belongs to the program (`shaders`): beside the program where it is installed
/// (../share/plimsoll), else in the source tree that it was built from.
std::filesystem::path program_files(const std::string& folder);

/// The same of files that the build makes (`report`), else in the build tree.
std::filesystem::path built_files(const std::string& folder);

}  // namespace app
