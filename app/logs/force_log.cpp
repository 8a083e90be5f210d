#include "app/logs/force_log.h"

#include "app/logs/force_writer.h"
#include "app/logs/hdf5_log.h"
#include "app/logs/log_rows.h"

namespace app {
namespace {

/// CSV.
ForceLog read_force_rows(const std::filesystem::path& file) {
  ForceLog log;
  std::vector<double> numbers(force_columns().size());
  read_log(file, force_header(), "a log of forces", [&](std::string_view text, int line) {
    const LogRow row = read_log_row(text, file, line, numbers);
    ForceTrack& track = log[std::string(row.body)];
    track.columns.resize(numbers.size());
    track.times.push_back(row.time);
    for (std::size_t i = 0; i < numbers.size(); ++i) track.columns[i].push_back(numbers[i]);
  });
  return log;
}

}  // namespace

std::optional<ForceLog> read_forces(const std::filesystem::path& file) {
  return is_hdf5(file) ? read_hdf5_forces(file) : read_force_rows(file);
}

}  // namespace app
