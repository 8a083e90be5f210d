#include "app/logs/log_rows.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>

#include "app/scene/diagnostics.h"

namespace app {
namespace {

double number_in_log(std::string_view text, const std::filesystem::path& file, int line) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    refuse_row(file, line, fmt::format("found \"{}\", expected a finite number", text));
  return value;
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

void refuse_row(const std::filesystem::path& file, int line, const std::string& message) {
  throw scene::InputError(
      {{.place = {.file = file, .line = line, .column = 1}, .message = message}});
}

LogRow read_log_row(std::string_view text, const std::filesystem::path& file, int line,
                    std::span<double> numbers, LogField field) {
  const std::vector<std::string_view> fields = split(text);
  const std::size_t expected = numbers.size() + 2;
  if (fields.size() != expected)
    refuse_row(file, line, fmt::format("found {} fields, expected {}", fields.size(), expected));
  const double time = number_in_log(fields[0], file, line);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = field == LogField::may_be_empty && fields[i + 2].empty()
                     ? std::nan("")
                     : number_in_log(fields[i + 2], file, line);
  return {time, fields[1]};
}

std::string written_header(const std::filesystem::path& file, std::string_view header) {
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  std::getline(stream, line);
  if (!line.empty() && line.back() == '\r') line.pop_back();
  const bool is_older = line.starts_with("time,body,") && header.starts_with(line + ",");
  return is_older ? line : std::string(header);
}

void read_rows(const std::filesystem::path& file, std::string_view header, const std::string& kind,
               const std::function<void(std::string_view row, int line)>& read) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file))
    throw scene::InputError(
        file, fmt::format("cannot be read; expected {} that plimsoll run has written", kind));
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const bool cut_off = stream.eof();  // a last line without an end: its writer was stopped
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (number == 1) {
      if (line != header) refuse_row(file, 1, fmt::format("expected the header {}", header));
      continue;
    }
    if (cut_off) break;
    read(line, number);
  }
}

}  // namespace app
