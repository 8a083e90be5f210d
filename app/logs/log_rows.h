#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Logs of a run as CSV, read back: `time,body,…`, one row a body a time, numbers only behind the
/// name.

namespace app {

/// The head of a row.
struct LogRow {
  double time = 0;        ///< [s]
  std::string_view body;  ///< Of the text that was read.
};

/// @throws InputError for row `line` of a log.
[[noreturn]] void refuse_row(const std::filesystem::path& file, int line,
                             const std::string& message);

/// Reads a row. @param numbers   Filled with what stands behind the name.
/// @throws InputError unless there are just as many, all finite.
LogRow read_log_row(std::string_view text, const std::filesystem::path& file, int line,
                    std::span<double> numbers);

/// Hands each row of a log to `read`, with the number of its line. A last line that was cut off is
/// left out. @param kind   Of the log, as a fault names it: `a trajectory`.
/// @throws InputError if the file cannot be read or begins with another header.
void read_rows(const std::filesystem::path& file, std::string_view header, const std::string& kind,
               const std::function<void(std::string_view row, int line)>& read);

}  // namespace app
