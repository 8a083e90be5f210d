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
#include "app/run/rig_totals.h"
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

  /// Takes the state at a time as logged: a resumed run has its row.
  void take_as_logged(double time) { due_.due(time); }

  /// To be called before each step: it keeps the velocities that probes compare.
  void before_step(const std::vector<hydro::BodyState>& states) { probes_.before_step(states); }

  /// Sums up the present state and queues its rows if the scene wants some.
  /// @throws OutputError of rows before
  void keep(const engine::Simulation& simulation, RigTotals& totals);

  /// Waits until all rows are in the files and cannot be lost. @throws OutputError
  LogPosition save();

  /// Writes all rows and ends the log. @throws OutputError
  void finish();

  double seconds() const { return seconds_; }  ///< Wall time of the caller for rows so far.

 private:
  void add(const engine::Simulation& simulation, const engine::RigReadings& rig);
  std::vector<std::vector<double>> table_numbers(const engine::Simulation& simulation,
                                                 const engine::RigReadings& rig) const;

  const bool forces_;
  const bool interiors_;
  const bool probed_;
  std::unique_ptr<Log> log_;
  Schedule due_;
  double seconds_ = 0;
  Probes probes_;
  RigLog rig_;
  Background logging_;  ///< Declared last because it uses the log.
};

}  // namespace app
