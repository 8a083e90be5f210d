#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/forked_call.h"

/// @file
/// Texts and numbers as bytes between two processes of this program: records of any length, which
/// are read in the order in which they were written.

namespace app {

/// Writes a record of values.
template <class T>
void put_record(const CallOutput& output, std::span<const T> values) {
  const auto length = static_cast<std::uint64_t>(values.size_bytes());
  output({reinterpret_cast<const char*>(&length), sizeof length});
  output({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
}

/// Writes a text as a record.
inline void put_record(const CallOutput& output, std::string_view text) {
  put_record(output, std::span<const char>(text));
}

/// Reads records. The bytes must outlive it.
class ByteRecords {
 public:
  explicit ByteRecords(std::string_view bytes) : rest_(bytes) {}

  bool at_end() const { return rest_.empty(); }

  /// Returns the bytes of the next record. @throws std::logic_error if it is not complete
  std::string_view bytes() {
    std::uint64_t length = 0;
    if (rest_.size() >= sizeof length) std::memcpy(&length, rest_.data(), sizeof length);
    if (rest_.size() < sizeof length || rest_.size() - sizeof length < length)
      throw std::logic_error("the answer of another process is incomplete");
    const std::string_view record = rest_.substr(sizeof length, length);
    rest_.remove_prefix(sizeof length + length);
    return record;
  }

  /// Returns the next record as values.
  template <class T>
  std::vector<T> values() {
    const std::string_view record = bytes();
    std::vector<T> values(record.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), record.data(), values.size() * sizeof(T));
    return values;
  }

 private:
  std::string_view rest_;
};

}  // namespace app
