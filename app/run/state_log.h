#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/assembly/built_scene.h"
#include "app/base/background.h"
#include "app/base/schedule.h"
#include "app/logs/make_log.h"
#include "app/logs/probes.h"
#include "app/logs/rig_log.h"
#include "app/scene/scene.h"
#include "engine/simulation.h"

namespace app {

/// Logs the states of a simulation as its scene asks. Files are written on a thread of their own if
/// the simulation has several.
class StateLog {
 public:
  /// Opens the log (make_log.h). The scene and what is built from it must outlive it.
  /// @param threads   Number of threads that the simulation may use.
  /// @throws InputError if the log cannot be written or ends before the position
  StateLog(const scene::Scene& scene, const assembly::BuiltScene& built, LogFormat format,
           const std::filesystem::path& folder, int threads,
           const std::optional<LogPosition>& resumed = {});

  /// Returns true if the scene wants a row at a time, which is taken to be logged then.
  bool due(double time) { return due_.due(time); }

  /// True if a row has readings of lines, joints, machines or controls.
  bool reads_rig() const { return !rig_.empty(); }

  /// To be called before each step: it keeps the velocities that probes compare.
  void before_step(const std::vector<hydro::BodyState>& states) { probes_.before_step(states); }

  /// Queues the rows of the present state.
  /// @param rig   Its readings; they are not looked at unless `reads_rig`.
  /// @throws OutputError of rows before
  void add(const engine::Simulation& simulation, const engine::RigReadings& rig);

  /// Waits until all rows are in the files and cannot be lost. @throws OutputError
  LogPosition save();

  /// Writes all rows and ends the log. @throws OutputError
  void finish();

 private:
  std::vector<std::vector<double>> table_numbers(const engine::Simulation& simulation,
                                                 const engine::RigReadings& rig) const;

  const bool forces_;
  const bool interiors_;
  const bool probed_;
  std::unique_ptr<Log> log_;
  Schedule due_;
  Probes probes_;
  RigLog rig_;
  Background logging_;  ///< Declared last because it uses the log.
};

}  // namespace app
