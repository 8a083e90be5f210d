#include "app/base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace app {
namespace {

/// Waits for the lock of an open file. False if there are no locks here.
bool lock_file(int handle, bool& waited) {
  if (::flock(handle, LOCK_EX | LOCK_NB) == 0) return true;
  if (errno != EWOULDBLOCK) return false;
  waited = true;
  while (::flock(handle, LOCK_EX) != 0)
    if (errno != EINTR) return false;
  return true;
}

/// Whether the open file is the one that has this name now; who had the lock before removed his.
bool has_name(int handle, const std::filesystem::path& name) {
  struct stat open = {};
  struct stat named = {};
  return ::fstat(handle, &open) == 0 && ::stat(name.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& file) : file_(file) {
  if (file_.empty()) return;
  std::error_code ignored;
  std::filesystem::create_directories(file_.parent_path(), ignored);
  while (!try_lock()) {
  }
}

/// False if the file was removed meanwhile.
bool FileLock::try_lock() {
  constexpr mode_t kOwnerOnly = 0600;
  handle_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kOwnerOnly);
  if (handle_ < 0) return true;  // without a lock: the folder cannot be written
  const bool locked = lock_file(handle_, waited_);
  if (locked && has_name(handle_, file_)) return true;
  ::close(handle_);
  handle_ = -1;
  return !locked;
}

FileLock::~FileLock() {
  if (handle_ < 0) return;
  ::unlink(file_.c_str());
  ::close(handle_);
}

}  // namespace app
