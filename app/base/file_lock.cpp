#include "app/base/file_lock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <system_error>

namespace app {
namespace {

/// True if the open file still has this name: the previous holder of a lock removes its file.
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

/// Opens and locks the file. @return false if the file was removed meanwhile.
bool FileLock::try_lock() {
  constexpr mode_t kOwnerOnly = 0600;
  lock_ = LockedFile(::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kOwnerOnly));
  if (!lock_.is_open()) return true;  // no lock is possible: the folder cannot be written
  bool locked = lock_.try_lock(LockedFile::Lock::exclusive);
  if (!locked) {
    waited_ = true;
    locked = lock_.wait_for_lock();
  }
  if (locked && has_name(lock_.descriptor(), file_)) return true;
  lock_ = LockedFile();
  return !locked;
}

FileLock::~FileLock() {
  if (lock_.is_open()) ::unlink(file_.c_str());
}

}  // namespace app
