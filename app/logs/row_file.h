#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace app {

/// A CSV file that is written while a run goes on. What was added is in the file when `add`
/// returns.
class RowFile {
 public:
  /// Replaces the file by one of the header line. @throws InputError if it cannot be written.
  RowFile(const std::filesystem::path& file, std::string_view header);

  /// @param rows   Whole lines. @throws OutputError if the disk is full.
  void add(const fmt::memory_buffer& rows);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace app
