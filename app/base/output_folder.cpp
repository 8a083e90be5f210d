#include "app/base/output_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "app/scene/faults.h"

namespace app {

OutputFolder::OutputFolder(const std::filesystem::path& path, Use use) : path_(path) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) throw InputError(path_, fmt::format("cannot be made: {}", error.message()));
  lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) throw InputError(path_, fmt::format("cannot be opened: {}", std::strerror(errno)));
  // File systems that know no locks get none.
  if (::flock(lock_, (use == Use::alone ? LOCK_EX : LOCK_SH) | LOCK_NB) != 0 &&
      errno == EWOULDBLOCK) {
    ::close(lock_);
    throw InputError(path_, "another run is writing to this folder; name another with --out");
  }
}

OutputFolder::~OutputFolder() { ::close(lock_); }

}  // namespace app
