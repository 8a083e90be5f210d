#include "app/base/locked_file.h"

#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace app {

LockedFile::LockedFile(LockedFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

LockedFile& LockedFile::operator=(LockedFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

LockedFile::~LockedFile() {
  if (is_open()) ::close(descriptor_);
}

bool LockedFile::try_lock(Lock lock) const {
  const int kind = lock == Lock::exclusive ? LOCK_EX : LOCK_SH;
  return ::flock(descriptor_, kind | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

bool LockedFile::wait_for_lock() const {
  while (::flock(descriptor_, LOCK_EX) != 0)
    if (errno != EINTR) return false;
  return true;
}

}  // namespace app
