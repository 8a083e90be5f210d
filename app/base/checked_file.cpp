#include "app/base/checked_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kWord = sizeof(std::uint64_t);

/// Describes the fault in the bytes of a file; empty if there is none.
std::string fault_of(const std::string& bytes, const std::string& identity,
                     std::optional<std::size_t> size) {
  if (bytes.size() < kWord || std::memcmp(bytes.data(), identity.data(), kWord) != 0)
    return "is no file of added mass";
  if (size && bytes.size() != *size)
    return fmt::format("is damaged: {} bytes, expected {}", bytes.size(), *size);
  if (bytes.size() < 2 * kWord) return fmt::format("is damaged: {} bytes", bytes.size());
  std::uint64_t checksum = 0;
  std::memcpy(&checksum, bytes.data() + bytes.size() - kWord, kWord);
  if (checksum != hash_of({bytes.data(), bytes.size() - kWord}))
    return "is damaged: its checksum is wrong";
  const bool own = bytes.starts_with(identity) && bytes.size() >= identity.size() + kWord;
  return own ? "" : "belongs to another mesh or method";
}

/// Reads at most the first `most` + 1 bytes of a file; none if there is no file.
/// @throws std::runtime_error if the file exists but cannot be read
std::optional<std::string> read_bytes(const fs::path& file, std::uintmax_t most) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) return std::nullopt;
  if (error) throw std::runtime_error("cannot be read: " + error.message());
  if (!fs::is_regular_file(status)) throw std::runtime_error("is no ordinary file");
  const std::uintmax_t length = fs::file_size(file, error);
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(std::min(length, most) + 1), '\0');
  if (!error && stream.is_open())
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (error || !stream.is_open() || stream.bad()) throw std::runtime_error("cannot be read");
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

}  // namespace

std::uint64_t hash_of(std::span<const char> bytes) {
  std::uint64_t hash = 0xcbf29ce484222325 ^ bytes.size();
  while (!bytes.empty()) {
    const std::size_t length = std::min(bytes.size(), kWord);
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), length);
    hash = (hash ^ word) * std::uint64_t{0x100000001b3};
    // A product's upper bits do not affect its lower ones: two changed signs would cancel.
    hash ^= hash >> 32;
    bytes = bytes.subspan(length);
  }
  return hash;
}

std::string checked(const std::string& identity, std::string_view content) {
  std::string bytes = identity;
  bytes += content;
  append(bytes, hash_of(bytes));
  return bytes;
}

std::optional<std::string> read_checked(const fs::path& file, const std::string& identity,
                                        std::optional<std::size_t> size) {
  std::optional<std::size_t> whole;
  if (size) whole = identity.size() + *size + kWord;
  std::optional<std::string> bytes =
      read_bytes(file, whole ? *whole : std::numeric_limits<std::uint32_t>::max());
  if (!bytes) return std::nullopt;
  const std::string fault = fault_of(*bytes, identity, whole);
  if (!fault.empty()) throw std::runtime_error(fault);
  bytes->resize(bytes->size() - kWord);
  bytes->erase(0, identity.size());
  return bytes;
}

}  // namespace app
