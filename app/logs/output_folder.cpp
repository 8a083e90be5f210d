#include "app/logs/output_folder.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "app/scene/diagnostics.h"

namespace app {

OutputFolder::OutputFolder(const std::filesystem::path& path, Use use) : path_(path) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) throw scene::InputError(path_, fmt::format("cannot be made: {}", error.message()));
  lock_ = LockedFile(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!lock_.is_open())
    throw scene::InputError(path_, fmt::format("cannot be opened: {}", std::strerror(errno)));
  using Lock = LockedFile::Lock;
  if (!lock_.try_lock(use == Use::alone ? Lock::exclusive : Lock::shared))
    throw scene::InputError(path_,
                            "another run is writing to this folder; name another with --out");
}

}  // namespace app
