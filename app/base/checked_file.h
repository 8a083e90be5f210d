#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

/// @file
/// Files of the user's cache. Each holds its identity (all inputs that the content depends on), the
/// content and a checksum.

namespace app {

/// Computes the FNV-1a hash (Fowler, Noll, Vo) over 64-bit words instead of bytes, in an eighth of
/// the time. The upper bits are mixed into the lower ones after each word. A change of any one byte
/// changes the hash.
std::uint64_t hash_of(std::span<const char> bytes);

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

template <class T>
void append(std::string& bytes, T value) {
  append(bytes, &value, 1);
}

/// Takes a value from the front of what `append` has written.
/// @throws std::invalid_argument where the bytes end before it does
template <class T>
T take(std::string_view& bytes) {
  T value;
  if (bytes.size() < sizeof value) throw std::invalid_argument("the state is cut off");
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return value;
}

/// Returns all bytes of a file. `identity` begins with an 8-byte word that marks the kind of file.
std::string checked(const std::string& identity, std::string_view content);

/// Reads the content of a file; none if there is no file.
/// @param size   Expected size of the content [bytes]; none accepts any size.
/// @throws std::runtime_error that says what is wrong with the file
std::optional<std::string> read_checked(const std::filesystem::path& file,
                                        const std::string& identity,
                                        std::optional<std::size_t> size);

}  // namespace app
