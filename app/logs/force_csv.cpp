#include "app/logs/force_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "app/logs/log_rows.h"

namespace app {

std::string force_header() { return fmt::format("time,body,{}", fmt::join(force_columns(), ",")); }

ForceWriter::ForceWriter(const std::filesystem::path& file, std::vector<std::string> names,
                         const std::optional<FilePosition>& kept)
    : names_(std::move(names)), file_(file, force_header(), kept) {}

void ForceWriter::add(double time, const std::vector<engine::BodyForces>& forces) {
  fmt::memory_buffer rows;
  for (std::size_t i = 0; i < forces.size(); ++i)
    fmt::format_to(std::back_inserter(rows), "{},{},{}\n", time, names_[i],
                   fmt::join(force_row(forces[i]), ","));
  file_.add(rows);
}

ForceLog read_force_csv(const std::filesystem::path& file) {
  ForceLog log;
  std::vector<double> numbers(force_columns().size());  // Columns that the log lacks stay 0.
  const std::string header = written_header(file, force_header());
  const auto given = static_cast<std::size_t>(std::ranges::count(header, ',')) - 1;
  read_rows(file, header, "a log of forces", [&](std::string_view text, int line) {
    const LogRow row = read_log_row(text, file, line, std::span(numbers).first(given));
    ForceTrack& track = log[std::string(row.body)];
    track.columns.resize(numbers.size());
    track.times.push_back(row.time);
    for (std::size_t i = 0; i < numbers.size(); ++i) track.columns[i].push_back(numbers[i]);
  });
  return log;
}

}  // namespace app
