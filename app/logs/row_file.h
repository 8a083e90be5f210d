#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/base/running_hash.h"

namespace app {

/// How far a file has been written.
struct FilePosition {
  std::uint64_t bytes = 0;
  std::uint64_t hash = 0;  ///< RunningHash of those bytes.
};

/// A CSV file that is written during a run. Rows are in the file when `add` returns.
class RowFile {
 public:
  /// Replaces the file by the header line, or keeps its bytes up to a position, which end with a
  /// whole row.
  /// @throws InputError if the file cannot be written, or if it is shorter than that or holds other
  ///     bytes
  RowFile(const std::filesystem::path& file, std::string_view header,
          const std::optional<FilePosition>& kept);

  /// @param rows   Whole lines. @throws OutputError if the disk is full.
  void add(const fmt::memory_buffer& rows);

  /// Flushes all rows to the disk. @throws OutputError, as `check_place` does
  FilePosition save();

  /// @throws OutputError if the file has been removed or replaced, so that no one finds its rows
  void check_place() const;

 private:
  void keep(const FilePosition& kept);
  [[noreturn]] void fail(const std::string& why) const;

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  RunningHash hash_;
};

}  // namespace app
