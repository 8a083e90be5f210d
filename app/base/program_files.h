#pragma once

#include <filesystem>
#include <string>

namespace app {

/// Returns a folder of the program's data (`shaders`): in ../share/plimsoll beside an installed
/// program, else in the source tree that it was built from.
std::filesystem::path program_files(const std::string& folder);

/// Returns a folder of files that the build makes (`report`): as for `program_files`, but the build
/// tree takes the place of the source tree.
std::filesystem::path built_files(const std::string& folder);

}  // namespace app
