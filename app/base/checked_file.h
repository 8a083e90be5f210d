#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// @file
/// Files of the user's cache: all that their content depends on, the content, and a checksum.

namespace app {

/// FNV-1a (Fowler, Noll, Vo) of words of 64 bits instead of bytes, in an eighth of the time, each
/// mixed downward too: any one byte that is changed changes it.
std::uint64_t hash_of(std::span<const char> bytes);

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

template <class T>
void append(std::string& bytes, T value) {
  append(bytes, &value, 1);
}

/// Everything in a file. `identity` begins with a word of 8 bytes that tells such files from
/// others.
std::string checked(const std::string& identity, std::string_view content);

/// The content of a file; none if there is no file.
/// @param size   Of the content [bytes]; none: any.
/// @throws std::runtime_error that says what is wrong with the file
std::optional<std::string> read_checked(const std::filesystem::path& file,
                                        const std::string& identity,
                                        std::optional<std::size_t> size);

}  // namespace app
