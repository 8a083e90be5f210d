#include "app/base/program_files.h"

#include <system_error>

namespace app {

namespace {

/// Returns the folder beside the installed program, else the folder of that name in `otherwise`.
std::filesystem::path installed_or(const std::filesystem::path& otherwise,
                                   const std::string& folder) {
  std::error_code error;
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

}  // namespace app
