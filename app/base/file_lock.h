#pragma once

#include <filesystem>

#include "app/base/locked_file.h"

namespace app {

/// Lock file for work that only one process at a time may do. On a file system without locks, every
/// process proceeds.
class FileLock {
 public:
  /// Waits for the lock.
  /// @param file   Lock file, created with the folders above it; an empty path locks nothing.
  explicit FileLock(const std::filesystem::path& file);
  /// Releases the lock and removes the file.
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// True if another process held the lock at first.
  bool waited() const { return waited_; }

 private:
  bool try_lock();

  std::filesystem::path file_;
  LockedFile lock_;
  bool waited_ = false;
};

}  // namespace app
