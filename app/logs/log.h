#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/logs/table_log.h"
#include "engine/hollows/interior_water.h"
#include "engine/record/body_forces.h"
#include "hydro/spatial.h"

/// @file
/// The log of a run: its motion, the forces if the scene asks for them, and tables of what else it
/// has: probes, lines, joints, machines, controls.

namespace app {

/// The subject of a log.
struct LogSubject {
  std::vector<std::string> bodies;  ///< Names of the bodies.
  bool forces = false;              ///< Forces are logged.
  bool interiors = false;           ///< The water in pockets is logged.
  std::vector<LogTable> tables;     ///< Each has at least one name.
  std::string scene;                ///< The scene's file.
  std::string title;
};

/// The part of a log that a resumed run keeps.
struct LogPosition {
  std::uint64_t rows = 0;                       ///< Number of logged times.
  FilePosition trajectory;                      ///< Position in trajectory.csv.
  FilePosition forces;                          ///< Position in forces.csv.
  FilePosition interior;                        ///< Position in interior.csv.
  std::vector<FilePosition> tables = {};        ///< Positions in the tables' files.
  std::vector<std::uint64_t> hdf5_hashes = {};  ///< Hashes of the rows of each series of run.h5.
};

/// Logged quantities of an instant.
struct LogEntry {
  double time = 0;                                ///< [s]
  const std::vector<hydro::BodyState>& states;    ///< One state per body.
  const std::vector<engine::BodyForces>& forces;  ///< On every body; empty if not logged.
  const std::vector<engine::InteriorState>&
      interiors;                                   ///< One entry per body; empty if not logged.
  const std::vector<std::vector<double>>& tables;  ///< The numbers of each table.
};

/// Receives rows during a run, all from one thread.
class Log {
 public:
  virtual ~Log() = default;

  /// Adds a row per body, per pocket and per name of a table, in the order of the names.
  /// @throws OutputError if the log cannot be written, usually because the disk is full
  virtual void add(const LogEntry& entry) = 0;

  /// Saves all rows so far, even if the program is killed later.
  /// @throws OutputError
  virtual LogPosition save() = 0;

  /// Writes all rows and ends the log. @throws OutputError, also if a file has been removed or
  /// replaced
  virtual void finish() = 0;
};

}  // namespace app
