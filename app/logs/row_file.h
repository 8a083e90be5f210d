#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

namespace app {

/// A CSV file that is written during a run. Rows are in the file when `add` returns.
class RowFile {
 public:
  /// Replaces the file by the header line, or keeps its first `kept` bytes, which end with a whole
  /// row.
  /// @throws InputError if the file cannot be written or is shorter than that.
  RowFile(const std::filesystem::path& file, std::string_view header,
          const std::optional<std::uint64_t>& kept);

  /// @param rows   Whole lines. @throws OutputError if the disk is full.
  void add(const fmt::memory_buffer& rows);

  /// Flushes all rows to the disk. @return the length of the file [bytes]
  /// @throws OutputError
  std::uint64_t save();

 private:
  [[noreturn]] void fail() const;

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace app
