#include "app/base/program_files.h"

#include <system_error>

namespace app {

namespace {

std::filesystem::path own_folder;  ///< Set once, before it is read.

/// Returns the folder beside the installed program, else the folder of that name in `otherwise`.
std::filesystem::path installed_or(const std::filesystem::path& otherwise,
                                   const std::string& folder) {
  std::error_code error;
  if (!own_folder.empty() && std::filesystem::is_directory(own_folder / folder, error))
    return own_folder / folder;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path installed =
      program.parent_path().parent_path() / "share" / "plimsoll" / folder;
  if (!error && std::filesystem::is_directory(installed, error)) return installed;
  return otherwise / folder;
}

}  // namespace

std::filesystem::path program_files(const std::string& folder) {
  return installed_or(PLIMSOLL_SOURCE_DIR, folder);
}

std::filesystem::path built_files(const std::string& folder) {
  return installed_or(PLIMSOLL_BINARY_DIR, folder);
}

void look_for_program_files_in(const std::filesystem::path& folder) { own_folder = folder; }

}  // namespace app
