#include "app/logs/hdf5_log_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "app/logs/hdf5_layout.h"
#include "app/logs/hdf5_reader.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

constexpr std::string_view kMagic = "\x89HDF\r\n\x1a\n";

/// An open log with its times and bodies, and its series, which have a row per time.
struct OpenLog {
  /// @param all    The series that will be asked for.
  /// @param names  Name of a dataset of names; empty: none is read.
  OpenLog(const std::filesystem::path& path, const std::vector<Hdf5Series>& all,
          const std::string& names = "")
      : file(path), reader(path, datasets(all, names)), times(reader.numbers("time", {})) {
    if (!times.empty()) bodies = reader.texts("body");
  }

  static std::vector<std::string> datasets(const std::vector<Hdf5Series>& all,
                                           const std::string& names) {
    std::vector<std::string> datasets = {"time", "body"};
    if (!names.empty()) datasets.push_back(names);
    for (const Hdf5Series& series : all) datasets.push_back(series.name);
    return datasets;
  }

  std::vector<double> numbers(const Hdf5Series& series) const {
    std::vector<double> all = reader.numbers(series.name, series.shape);
    const std::size_t count = times.size() * series.shape.front() * width_of(series);
    if (all.size() < count)
      throw scene::InputError(
          file, fmt::format("{} has fewer rows than time, {}", series.name, times.size()));
    all.resize(count);
    return all;
  }

  [[noreturn]] void refuse(std::size_t row, const std::string& body, const std::string& why) const {
    throw scene::InputError(file, fmt::format("row {}, body {}: {}", row, body, why));
  }

  std::filesystem::path file;
  Hdf5Reader reader;
  std::vector<double> times;
  std::vector<std::string> bodies;
};

bool is_finite(double number) { return std::isfinite(number); }

/// Adds the columns of a series to the track of each body.
void add_columns(const OpenLog& log, const Hdf5Series& series, ForceLog& forces) {
  const std::size_t width = width_of(series);
  const std::size_t row = log.bodies.size() * width;
  const std::vector<double> numbers = log.numbers(series);
  const auto bad = std::ranges::find_if_not(numbers, is_finite);
  if (bad != numbers.end()) {
    const auto i = static_cast<std::size_t>(bad - numbers.begin());
    log.refuse(i / row, log.bodies[i % row / width], series.name + ": expected finite numbers");
  }
  for (std::size_t i = 0; i < row; ++i) {
    std::vector<double>& column = forces[log.bodies[i / width]].columns.emplace_back();
    for (std::size_t t = 0; t < log.times.size(); ++t) column.push_back(numbers[t * row + i]);
  }
}

}  // namespace

bool is_hdf5(const std::filesystem::path& file) {
  std::array<char, kMagic.size()> start{};
  std::ifstream(file, std::ios::binary).read(start.data(), start.size());
  return std::string_view(start.data(), start.size()) == kMagic;
}

Trajectory read_hdf5_trajectory(const std::filesystem::path& file) {
  const OpenLog log(file, state_series(1));
  const std::vector<double>& times = log.times;
  if (times.empty()) return {};
  Trajectory trajectory{.names = log.bodies, .tracks = {}};
  const std::size_t bodies = trajectory.names.size();
  std::vector<StateRow> rows(times.size() * bodies);
  std::size_t first = 0;
  for (const Hdf5Series& series : state_series(bodies)) {
    const std::size_t width = width_of(series);
    const std::vector<double> numbers = log.numbers(series);
    for (std::size_t i = 0; i < rows.size(); ++i)
      std::copy_n(numbers.begin() + i * width, width, rows[i].begin() + first);
    first += width;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string& name = trajectory.names[i % bodies];
    const double time = times[i / bodies];
    const bool finite = is_finite(time) && std::ranges::all_of(rows[i], is_finite);
    const std::string fault =
        finite ? add_row(name, time, rows[i], trajectory.tracks[name]) : "expected finite numbers";
    if (!fault.empty()) log.refuse(i / bodies, name, fault);
  }
  return trajectory;
}

std::optional<ForceLog> read_hdf5_forces(const std::filesystem::path& file) {
  const OpenLog log(file, force_series(1));
  const std::vector<Hdf5Series> all = force_series(log.bodies.size());
  if (!log.reader.has(all.front().name)) return std::nullopt;
  ForceLog forces;
  for (const std::string& name : log.bodies) forces[name].times = log.times;
  for (const Hdf5Series& series : all) add_columns(log, series, forces);
  return forces;
}

std::optional<TableRows> read_hdf5_table(const std::filesystem::path& file,
                                         const TableLayout& layout) {
  const OpenLog log(file, table_series(layout, 1), layout.key);
  if (log.times.empty() || !log.reader.has(layout.key)) return std::nullopt;
  TableRows table{.layout = layout, .names = log.reader.texts(layout.key), .tracks = {}};
  for (const std::string& name : table.names) table.tracks[name].times = log.times;
  for (const Hdf5Series& series : table_series(layout, table.names.size())) {
    const std::size_t width = width_of(series);
    const std::size_t row = table.names.size() * width;
    const std::vector<double> numbers = log.numbers(series);
    for (std::size_t i = 0; i < row; ++i) {
      std::vector<double>& column = table.tracks[table.names[i / width]].columns.emplace_back();
      for (std::size_t t = 0; t < log.times.size(); ++t) column.push_back(numbers[t * row + i]);
    }
  }
  return table;
}

}  // namespace app
