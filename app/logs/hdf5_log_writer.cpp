#include "app/logs/hdf5_log_writer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "app/base/output_error.h"
#include "app/logs/force_log.h"
#include "app/logs/hdf5_layout.h"
#include "app/logs/trajectory.h"

namespace app {
namespace {

const char* const kFormat = "1";  ///< Version of the layout.

/// Bodies per chunk, so that one body can be read without reading all.
constexpr std::size_t kChunkBodies = 16;

/// Rows per chunk. More rows hardly make the file smaller.
constexpr std::size_t kMostRows = 128;
constexpr std::size_t kFewestRows = 16;
constexpr std::size_t kMostWaiting = std::size_t{64} << 20;  ///< [bytes], if kFewestRows fit.

constexpr std::chrono::seconds kBetweenFlushes(1);

/// Returns all series of the bodies.
std::vector<Hdf5Series> series_of_bodies(const LogSubject& subject) {
  const std::size_t bodies = subject.bodies.size();
  std::vector<Hdf5Series> all = state_series(bodies);
  if (subject.forces)
    for (Hdf5Series& series : force_series(bodies)) all.push_back(std::move(series));
  return all;
}

std::size_t chunk_rows(const LogSubject& subject) {
  std::size_t numbers = 0;
  for (const Hdf5Series& series : series_of_bodies(subject)) numbers += width_of(series);
  numbers *= std::max<std::size_t>(1, subject.bodies.size());
  for (const LogTable& table : subject.tables) numbers += table.layout.width() * table.names.size();
  return std::clamp(kMostWaiting / (sizeof(double) * numbers), kFewestRows, kMostRows);
}

}  // namespace

Hdf5Log::Hdf5Log(const LogSubject& subject, const std::filesystem::path& file,
                 const std::optional<LogPosition>& kept)
    : subject_(subject),
      chunk_(chunk_rows(subject)),
      file_(file, kept ? Hdf5Writer::Mode::extend : Hdf5Writer::Mode::replace) {
  if (kept) find_structure(*kept);
}

Hdf5Log::~Hdf5Log() {
  try {
    finish();
  } catch (const OutputError&) {
    // A caller that needs the error calls `finish`.
  }
}

/// @param number_of   Finds or adds a series in the file.
void Hdf5Log::list_series(const AddSeries& number_of) {
  const auto entry = [&](const Hdf5Series& series) {
    return Series{.number = number_of(series), .columns = width_of(series), .waiting = {}};
  };
  for (const Hdf5Series& series : series_of_bodies(subject_)) series_.push_back(entry(series));
  for (const LogTable& table : subject_.tables) {
    tables_.emplace_back();
    for (const Hdf5Series& series : table_series(table.layout, table.names.size()))
      tables_.back().push_back(entry(series));
  }
}

/// Is called with the first row, so that a full disk is an error of the log.
void Hdf5Log::make_structure() {
  const std::array<std::size_t, 2> chunk = {chunk_, kChunkBodies};
  file_.set_attributes({{"format", kFormat},
                        {"plimsoll", PLIMSOLL_VERSION},
                        {"scene", subject_.scene},
                        {"title", subject_.title}});
  times_.number = file_.add_series({"time", "s", {}, {}}, chunk);
  file_.add_texts("body", subject_.bodies);
  for (const LogTable& table : subject_.tables) file_.add_texts(table.layout.key, table.names);
  list_series([&](const Hdf5Series& series) { return file_.add_series(series, chunk); });
  flush();
  started_ = true;
}

void Hdf5Log::find_structure(const LogPosition& kept) {
  auto hash = kept.hdf5_hashes.begin();
  const auto find = [&](const Hdf5Series& series) {
    if (hash == kept.hdf5_hashes.end()) throw std::runtime_error("a series has no hash");
    return file_.find_series(series, kept.rows, *hash++);
  };
  times_.number = find({"time", "s", {}, {}});
  list_series(find);
  written_ = kept.rows;
  started_ = true;
}

void Hdf5Log::add(const LogEntry& entry) {
  try {
    if (!started_) make_structure();
    wait(entry);
    const bool fills_chunk = (written_ + times_.waiting.size()) % chunk_ == 0;
    if (fills_chunk || is_time_to_flush()) write_waiting();
  } catch (const OutputError&) {
    ended_ = true;
    throw;
  }
}

void Hdf5Log::wait(const LogEntry& entry) {
  const auto distribute = [](auto next, std::vector<Series>& all) {
    for (Series& series : all) {
      const auto end = next + static_cast<std::ptrdiff_t>(series.columns);
      series.waiting.insert(series.waiting.end(), next, end);
      next = end;
    }
    return next;
  };
  times_.waiting.push_back(entry.time);
  for (std::size_t body = 0; body < entry.states.size(); ++body) {
    const StateRow state = row_of(entry.states[body]);
    std::vector<double> row(state.begin(), state.end());
    if (subject_.forces) std::ranges::copy(force_row(entry.forces[body]), std::back_inserter(row));
    distribute(row.begin(), series_);
  }
  for (std::size_t i = 0; i < tables_.size(); ++i)
    for (auto next = entry.tables[i].begin(); next != entry.tables[i].end();)
      next = distribute(next, tables_[i]);
}

/// Writes the times last, so that the file has all data of every time in it.
void Hdf5Log::write_waiting() {
  const auto write = [&](Series& series) {
    file_.append(series.number, series.waiting);
    series.waiting.clear();
  };
  if (times_.waiting.empty()) return;
  std::size_t numbers = times_.waiting.size();
  for (const Series& series : series_) numbers += series.waiting.size();
  for (const std::vector<Series>& table : tables_)
    for (const Series& series : table) numbers += series.waiting.size();
  written_ += times_.waiting.size();
  file_.reserve(sizeof(double) * numbers);
  std::ranges::for_each(series_, write);
  for (std::vector<Series>& table : tables_) std::ranges::for_each(table, write);
  write(times_);
  if (is_time_to_flush()) flush();
}

bool Hdf5Log::is_time_to_flush() const {
  return std::chrono::steady_clock::now() - flushed_ > kBetweenFlushes;
}

void Hdf5Log::flush() {
  file_.flush();
  flushed_ = std::chrono::steady_clock::now();
}

LogPosition Hdf5Log::save() {
  try {
    write_waiting();
    flush();
  } catch (const OutputError&) {
    ended_ = true;
    throw;
  }
  LogPosition position{.rows = written_};
  position.hdf5_hashes.push_back(file_.hash_of(times_.number));
  for (const Series& series : series_) position.hdf5_hashes.push_back(file_.hash_of(series.number));
  for (const std::vector<Series>& table : tables_)
    for (const Series& series : table) position.hdf5_hashes.push_back(file_.hash_of(series.number));
  return position;
}

void Hdf5Log::finish() {
  if (std::exchange(ended_, true)) return;
  if (started_) write_waiting();
  file_.close();
}

}  // namespace app
