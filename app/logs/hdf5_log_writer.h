#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/logs/hdf5_file.h"
#include "app/logs/log.h"

/// @file
/// The log of a run as HDF5 (hdf5_layout.h), written during the run.

namespace app {

/// Writes run.h5. Rows are buffered until a chunk is full or a second has passed, and `finish`
/// writes the rest. A killed program loses the rows of the last second.
class Hdf5Log : public Log {
 public:
  /// Replaces the file, or keeps its rows up to a position. Later rows, which a killed run has
  /// logged, remain until they are written again with the same numbers.
  /// @throws InputError if the file cannot be written or holds other rows, or the program has no
  ///     HDF5
  Hdf5Log(const LogSubject& subject, const std::filesystem::path& file,
          const std::optional<LogPosition>& kept = {});
  /// Writes the buffered rows if possible.
  ~Hdf5Log() override;

  void add(const LogEntry& entry) override;
  LogPosition save() override;
  void finish() override;

 private:
  /// A dataset and its buffered rows.
  struct Series {
    std::size_t number = 0;   ///< Number in the file.
    std::size_t columns = 1;  ///< Numbers per body or name.
    std::vector<double> waiting;
  };
  using AddSeries = std::function<std::size_t(const Hdf5Series&)>;

  void list_series(const AddSeries& number_of);
  void make_structure();
  void find_structure(const LogPosition& kept);
  void wait(const LogEntry& entry);
  void write_waiting();
  void flush();
  bool is_time_to_flush() const;

  LogSubject subject_;
  std::size_t chunk_;        ///< Rows of a chunk.
  std::size_t written_ = 0;  ///< Rows in the file.
  Hdf5Writer file_;
  bool started_ = false;
  std::chrono::steady_clock::time_point flushed_;
  bool ended_ = false;  ///< The file is closed or has failed; no more writes.
  Series times_;
  std::vector<Series> series_;               ///< Series of the bodies.
  std::vector<std::vector<Series>> tables_;  ///< Series of each table.
};

}  // namespace app
