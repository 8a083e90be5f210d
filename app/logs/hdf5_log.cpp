#include "app/logs/hdf5_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include "app/base/output_folder.h"
#include "app/logs/force_writer.h"
#include "app/scene/faults.h"

namespace app {
namespace {

constexpr std::string_view kMagic = "\x89HDF\r\n\x1a\n";
const char* const kFormat = "1";  ///< Of the layout.

/// Bodies of a chunk, so that to read one of very many is not to read all.
constexpr std::size_t kChunkBodies = 16;

/// Rows of a chunk. More of them make the file little smaller, and are lost by a program that is
/// killed.
constexpr std::size_t kMostRows = 128;
constexpr std::size_t kFewestRows = 16;
constexpr std::size_t kMostWaiting = std::size_t{64} << 20;  ///< [bytes], but for the fewest rows.

constexpr std::chrono::seconds kBetweenFlushes(1);

/// The numbers of `bodies`.
Hdf5Series series_of(std::string name, std::string units, std::vector<std::string> columns,
                     std::size_t bodies) {
  if (columns.size() == 1) return {std::move(name), std::move(units), {}, {bodies}};
  const std::size_t width = columns.size();
  return {std::move(name), std::move(units), std::move(columns), {bodies, width}};
}

std::vector<Hdf5Series> state_series(std::size_t bodies) {
  return {series_of("position", "m", {"x", "y", "z"}, bodies),
          series_of("orientation", "1", {"qw", "qx", "qy", "qz"}, bodies),
          series_of("linear_velocity", "m/s", {"vx", "vy", "vz"}, bodies),
          series_of("angular_velocity", "rad/s", {"wx", "wy", "wz"}, bodies)};
}

/// Of a column of forces.csv that is no part of a load.
std::string units_of(const std::string& column) {
  if (column == "wetted_area") return "m^2";
  if (column == "displaced_volume") return "m^3";
  return "J";
}

/// The columns of forces.csv, the six of a load as one.
std::vector<Hdf5Series> force_series(std::size_t bodies) {
  constexpr std::string_view kFirst = "_fx";
  constexpr std::size_t kLoad = 6;
  const std::vector<std::string> columns = force_columns();
  std::vector<Hdf5Series> all;
  for (auto column = columns.begin(); column != columns.end();) {
    const bool is_load = column->ends_with(kFirst);
    const auto end = column + (is_load ? kLoad : 1);
    const std::string name = column->substr(0, column->size() - (is_load ? kFirst.size() : 0));
    all.push_back(series_of(name, is_load ? "N, N m" : units_of(name), {column, end}, bodies));
    column = end;
  }
  return all;
}

std::size_t width_of(const Hdf5Series& series) {
  return std::max<std::size_t>(1, series.columns.size());
}

/// All of them, by the number of bodies and whether forces are logged.
std::vector<Hdf5Series> all_series(const LogSubject& subject) {
  const std::size_t bodies = subject.bodies.size();
  std::vector<Hdf5Series> all = state_series(bodies);
  if (subject.forces)
    for (Hdf5Series& series : force_series(bodies)) all.push_back(std::move(series));
  return all;
}

std::size_t chunk_rows(const LogSubject& subject) {
  std::size_t numbers = 0;
  for (const Hdf5Series& series : all_series(subject)) numbers += width_of(series);
  const std::size_t row =
      sizeof(double) * numbers * std::max<std::size_t>(1, subject.bodies.size());
  return std::clamp(kMostWaiting / row, kFewestRows, kMostRows);
}

/// A log that is read: its times and bodies, and its series with a row for each time.
struct OpenLog {
  explicit OpenLog(const std::filesystem::path& path)
      : file(path), reader(path), times(reader.numbers("time", {})) {
    if (!times.empty()) bodies = reader.texts("body");
  }

  std::vector<double> numbers(const Hdf5Series& series) const {
    std::vector<double> all = reader.numbers(series.name, series.shape);
    const std::size_t count = times.size() * bodies.size() * width_of(series);
    if (all.size() < count)
      throw InputError(file,
                       fmt::format("{} has fewer rows than time, {}", series.name, times.size()));
    all.resize(count);
    return all;
  }

  [[noreturn]] void refuse(std::size_t row, const std::string& body, const std::string& why) const {
    throw InputError(file, fmt::format("row {}, body {}: {}", row, body, why));
  }

  std::filesystem::path file;
  Hdf5Reader reader;
  std::vector<double> times;
  std::vector<std::string> bodies;
};

bool is_finite(double number) { return std::isfinite(number); }

/// Adds the columns of a series to each body's.
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

Hdf5Log::Hdf5Log(const LogSubject& subject, const std::filesystem::path& file)
    : subject_(subject), chunk_(chunk_rows(subject)), file_(file) {}

Hdf5Log::~Hdf5Log() {
  try {
    finish();
  } catch (const OutputError&) {
    // Whoever wants to know has called `finish`.
  }
}

/// With the first row, so that a disk that is full already is an error of the log's.
void Hdf5Log::make_structure() {
  const std::array<std::size_t, 2> chunk = {chunk_, kChunkBodies};
  file_.set_attributes({{"format", kFormat},
                        {"plimsoll", PLIMSOLL_VERSION},
                        {"scene", subject_.scene},
                        {"title", subject_.title}});
  times_.number = file_.add_series({"time", "s", {}, {}}, chunk);
  file_.add_texts("body", subject_.bodies);
  for (const Hdf5Series& series : all_series(subject_))
    series_.push_back({.number = file_.add_series(series, chunk), .columns = width_of(series)});
  file_.flush();
  started_ = true;
}

void Hdf5Log::add(double time, const std::vector<hydro::BodyState>& states,
                  const std::vector<engine::BodyForces>& forces) {
  try {
    if (!started_) make_structure();
    wait(time, states, forces);
    if (times_.waiting.size() == chunk_) write_waiting();
  } catch (const OutputError&) {
    ended_ = true;
    throw;
  }
}

void Hdf5Log::wait(double time, const std::vector<hydro::BodyState>& states,
                   const std::vector<engine::BodyForces>& forces) {
  times_.waiting.push_back(time);
  for (std::size_t body = 0; body < states.size(); ++body) {
    const StateRow state = row_of(states[body]);
    std::vector<double> row(state.begin(), state.end());
    if (subject_.forces) std::ranges::copy(force_row(forces[body]), std::back_inserter(row));
    auto next = row.begin();
    for (Series& series : series_) {
      series.waiting.insert(series.waiting.end(), next, next + series.columns);
      next += series.columns;
    }
  }
}

/// The times last: of what they tell nothing is missing.
void Hdf5Log::write_waiting() {
  const auto write = [&](Series& series) {
    file_.append(series.number, series.waiting);
    series.waiting.clear();
  };
  if (times_.waiting.empty()) return;
  std::size_t numbers = times_.waiting.size();
  for (const Series& series : series_) numbers += series.waiting.size();
  file_.reserve(sizeof(double) * numbers);
  std::ranges::for_each(series_, write);
  write(times_);
  if (std::chrono::steady_clock::now() - flushed_ > kBetweenFlushes) flush();
}

void Hdf5Log::flush() {
  file_.flush();
  flushed_ = std::chrono::steady_clock::now();
}

void Hdf5Log::finish() {
  if (std::exchange(ended_, true)) return;
  if (started_) write_waiting();
  file_.close();
}

bool is_hdf5(const std::filesystem::path& file) {
  std::array<char, kMagic.size()> start{};
  std::ifstream(file, std::ios::binary).read(start.data(), start.size());
  return std::string_view(start.data(), start.size()) == kMagic;
}

Trajectory read_hdf5_log(const std::filesystem::path& file) {
  const OpenLog log(file);
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
  const OpenLog log(file);
  const std::vector<Hdf5Series> all = force_series(log.bodies.size());
  if (!log.reader.has(all.front().name)) return std::nullopt;
  ForceLog forces;
  for (const std::string& name : log.bodies) forces[name].times = log.times;
  for (const Hdf5Series& series : all) add_columns(log, series, forces);
  return forces;
}

}  // namespace app
