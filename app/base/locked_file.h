#pragma once

namespace app {

/// An open file or folder and the lock on it. Both end with the object; the system drops the lock
/// of a process that is killed. A file system that knows no locks grants every lock.
class LockedFile {
 public:
  enum class Lock { exclusive, shared };

  LockedFile() = default;
  /// Takes over a descriptor; a negative one stands for a file that could not be opened.
  explicit LockedFile(int descriptor) : descriptor_(descriptor) {}
  LockedFile(LockedFile&& other) noexcept;
  LockedFile& operator=(LockedFile&& other) noexcept;
  ~LockedFile();

  bool is_open() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }

  /// Takes the lock unless another process holds it. @return false if one does
  bool try_lock(Lock lock) const;
  /// Waits for the exclusive lock. @return false if the file system knows no locks
  bool wait_for_lock() const;

 private:
  int descriptor_ = -1;
};

}  // namespace app
