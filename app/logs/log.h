#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/body_forces.h"
#include "hydro/spatial.h"

/// @file
/// What a run writes of its motion, and of the forces where the scene asks for them.

namespace app {

/// What a log is of.
struct LogSubject {
  std::vector<std::string> bodies;  ///< Names.
  bool forces = false;              ///< Logged as well.
  std::string scene;                ///< The scene's file.
  std::string title;
};

/// How much a log holds: what a resumed run keeps of it.
struct LogPosition {
  std::uint64_t rows = 0;              ///< Times that were added.
  std::uint64_t trajectory_bytes = 0;  ///< Length of trajectory.csv.
  std::uint64_t forces_bytes = 0;      ///< Length of forces.csv.
};

/// Takes rows while a run goes on, all from one thread.
class Log {
 public:
  virtual ~Log() = default;

  /// A row of each body in the order of the names. @param forces   Of every body, or else none.
  /// @throws OutputError if it cannot be written, most often since the disk is full
  virtual void add(double time, const std::vector<hydro::BodyState>& states,
                   const std::vector<engine::BodyForces>& forces) = 0;

  /// All rows up to here are in the file when it returns, whatever becomes of the program.
  /// @throws OutputError
  virtual LogPosition save() = 0;

  /// No more rows come: all are in the file when it returns. @throws OutputError
  virtual void finish() = 0;
};

}  // namespace app
