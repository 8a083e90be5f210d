#include "app/logs/table_log.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>

#include "app/logs/log_rows.h"

namespace app {

std::size_t TableLayout::width() const {
  std::size_t sum = 0;
  for (const TableSeries& one : series) sum += one.columns.size();
  return sum;
}

std::string TableLayout::header() const {
  std::string text = "time," + key;
  for (const TableSeries& one : series)
    for (const std::string& column : one.columns) text += "," + column;
  return text;
}

std::size_t TableLayout::column(const std::string& name) const {
  std::size_t index = 0;
  for (const TableSeries& one : series)
    for (const std::string& column : one.columns) {
      if (column == name) return index;
      ++index;
    }
  throw std::logic_error(file + " has no column " + name);
}

TableWriter::TableWriter(const std::filesystem::path& folder, const LogTable& table,
                         const std::optional<FilePosition>& kept)
    : names_(table.names),
      width_(table.layout.width()),
      file_(folder / table.layout.file, table.layout.header(), kept) {}

void TableWriter::add(double time, std::span<const double> numbers) {
  fmt::memory_buffer rows;
  const auto to = std::back_inserter(rows);
  for (std::size_t i = 0; i < names_.size(); ++i) {
    fmt::format_to(to, "{},{}", time, names_[i]);
    for (const double number : numbers.subspan(i * width_, width_)) {
      rows.push_back(',');
      if (!std::isnan(number)) fmt::format_to(to, "{}", number);
    }
    rows.push_back('\n');
  }
  file_.add(rows);
}

TableRows read_table_csv(const std::filesystem::path& file, const TableLayout& layout) {
  TableRows table{.layout = layout, .names = {}, .tracks = {}};
  std::vector<double> numbers(layout.width());
  read_rows(file, layout.header(), layout.kind, [&](std::string_view text, int line) {
    const LogRow row = read_log_row(text, file, line, numbers, LogField::may_be_empty);
    const auto [entry, is_new] = table.tracks.try_emplace(std::string(row.body));
    TableTrack& track = entry->second;
    if (is_new) {
      table.names.emplace_back(row.body);
      track.columns.resize(numbers.size());
    }
    if (!is_new && row.time <= track.times.back())
      refuse_row(file, line,
                 fmt::format("found time {} after {}, expected ascending times of {} {}", row.time,
                             track.times.back(), layout.key, row.body));
    track.times.push_back(row.time);
    for (std::size_t i = 0; i < numbers.size(); ++i) track.columns[i].push_back(numbers[i]);
  });
  return table;
}

}  // namespace app
