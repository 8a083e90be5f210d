#include "app/base/file_lock.h"

#include <fcntl.h>
#include <unistd.h>

#include <system_error>

#include "app/base/open_file.h"

namespace app {

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
  // The previous holder of a lock removes its file.
  if (locked && has_name(lock_.descriptor(), file_)) return true;
  lock_ = LockedFile();
  return !locked;
}

FileLock::~FileLock() {
  if (lock_.is_open()) ::unlink(file_.c_str());
}

}  // namespace app
