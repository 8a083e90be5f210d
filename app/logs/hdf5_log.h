#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/logs/force_log.h"
#include "app/logs/hdf5_file.h"
#include "app/logs/log.h"
#include "app/logs/trajectory.h"

/// @file
/// The log of a run as HDF5: T times of N bodies.
///
///     time                T                                   [s]
///     body                N names
///     position            T × N × 3: x, y, z                  [m]
///     orientation         T × N × 4: qw, qx, qy, qz
///     linear_velocity     T × N × 3: vx, vy, vz               [m/s]
///     angular_velocity    T × N × 3: wx, wy, wz               [rad/s]
///     buoyancy, …         T × N × 6: <load>_fx … _fz [N], <load>_tx … _tz [N m]
///     wetted_area, …      T × N, each further column of forces.csv
///
/// All bodies are in one dataset: a group for each of a thousand bodies takes longer than the CSV
/// files. Datasets have the attribute `units`, and `columns` for what their last dimension is, by
/// the names of the CSV files; the file has `format`, `plimsoll`, `scene` and `title`.

namespace app {

/// Writes run.h5. Rows wait until a chunk is full, and `finish` writes the rest: where the program
/// is killed a chunk is lost at most, and what was written in the last second.
class Hdf5Log : public Log {
 public:
  /// @throws InputError if the file cannot be written, or the program has no HDF5
  Hdf5Log(const LogSubject& subject, const std::filesystem::path& file);
  /// Writes what waits, if that is possible.
  ~Hdf5Log() override;

  void add(double time, const std::vector<hydro::BodyState>& states,
           const std::vector<engine::BodyForces>& forces) override;
  void finish() override;

 private:
  /// One dataset, and its rows that wait.
  struct Series {
    std::size_t number = 0;   ///< In the file.
    std::size_t columns = 1;  ///< Numbers of a body.
    std::vector<double> waiting;
  };

  void make_structure();
  void wait(double time, const std::vector<hydro::BodyState>& states,
            const std::vector<engine::BodyForces>& forces);
  void write_waiting();
  void flush();

  LogSubject subject_;
  std::size_t chunk_;  ///< Rows.
  Hdf5Writer file_;
  bool started_ = false;
  std::chrono::steady_clock::time_point flushed_;
  bool ended_ = false;  ///< Closed, or failed: not to be touched again.
  Series times_;
  std::vector<Series> series_;  ///< Of the bodies.
};

/// True if the file starts as an HDF5 file does.
bool is_hdf5(const std::filesystem::path& file);

/// The trajectory in a log, with as many rows as the log has times. @throws InputError
Trajectory read_hdf5_log(const std::filesystem::path& file);

/// The forces in a log, with as many rows; none if they were not logged. @throws InputError
std::optional<ForceLog> read_hdf5_forces(const std::filesystem::path& file);

}  // namespace app
