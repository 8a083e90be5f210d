#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Reader of the CSV logs of a run: `time,body,…`, with one row per body and time and only numbers
/// after the name.

namespace app {

/// Start of a row.
struct LogRow {
  double time = 0;        ///< [s]
  std::string_view body;  ///< Part of the text that was read.
};

/// Refuses row `line` of a log. @throws InputError always.
[[noreturn]] void refuse_row(const std::filesystem::path& file, int line,
                             const std::string& message);

/// Kind of a field after the name; an empty one is read as NaN.
enum class LogField { number, may_be_empty };

/// Reads a row.
/// @param numbers   Filled with the numbers after the name.
/// @throws InputError unless the row has as many numbers, all finite.
LogRow read_log_row(std::string_view text, const std::filesystem::path& file, int line,
                    std::span<double> numbers, LogField field = LogField::number);

/// Returns the header of a log: an older version may have written it without the last columns.
/// @param header   The present one.
std::string written_header(const std::filesystem::path& file, std::string_view header);

/// Calls `read` with each row of a log and its line number. A last line without an end is dropped.
/// @param kind   Kind of log that a fault names: `a trajectory`.
/// @throws InputError if the file cannot be read or begins with another header.
void read_rows(const std::filesystem::path& file, std::string_view header, const std::string& kind,
               const std::function<void(std::string_view row, int line)>& read);

}  // namespace app
