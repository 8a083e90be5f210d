#pragma once

#include <filesystem>

#include "app/base/locked_file.h"

namespace app {

/// Work that one process at a time does: a file that is there, and locked, while it is done. File
/// systems that know no locks let all pass.
class FileLock {
 public:
  /// Waits for the lock. @param file   Made for it, with the folders above; empty: there is no
  /// lock.
  explicit FileLock(const std::filesystem::path& file);
  /// Removes the file, too.
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// Another had it when it was asked for.
  bool waited() const { return waited_; }

 private:
  bool try_lock();

  std::filesystem::path file_;
  LockedFile lock_;
  bool waited_ = false;
};

}  // namespace app
