#pragma once

#include <cstdint>
#include <span>

namespace app {

/// The FNV-1a hash (Fowler, Noll, Vo) over 64-bit words of bytes that come in parts. It depends on
/// the bytes alone and not on how they are divided. As in `hash_of`, the upper bits are mixed into
/// the lower ones after each word.
class RunningHash {
 public:
  void add(std::span<const char> bytes);

  /// Returns the hash of all bytes so far.
  std::uint64_t value() const { return mixed(mixed(hash_, word_), size_); }

 private:
  static std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * std::uint64_t{0x100000001b3};
    return hash ^ (hash >> 32);
  }

  std::uint64_t hash_ = 0xcbf29ce484222325;  ///< Hash of all whole words.
  std::uint64_t word_ = 0;                   ///< The bytes after them.
  std::uint64_t size_ = 0;                   ///< Number of all bytes.
};

}  // namespace app
