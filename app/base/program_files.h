#pragma once

#include <filesystem>
#include <string>

namespace app {

/// Returns a folder of the program's data (`shaders`): in the folder of
/// `look_for_program_files_in`, or in ../share/plimsoll beside an installed program, else in the
/// source tree that it was built from.
std::filesystem::path program_files(const std::string& folder);

/// Returns a folder of files that the build makes (`report`): as for `program_files`, but the build
/// tree takes the place of the source tree.
std::filesystem::path built_files(const std::string& folder);

/// Looks for folders of data in this folder first. To be called before they are asked for, by a
/// library whose program is somebody else's.
void look_for_program_files_in(const std::filesystem::path& folder);

}  // namespace app
