#include "app/program_files.h"

#include <system_error>

namespace app {

std::filesystem::path program_files(const std::string& folder) {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path installed =
      program.parent_path().parent_path() / "share" / "plimsoll" / folder;
  if (!error && std::filesystem::is_directory(installed, error)) return installed;
  return std::filesystem::path(PLIMSOLL_SOURCE_DIR) / folder;
}

}  // namespace app
