#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "engine/base/rig_readings.h"
#include "engine/base/spec.h"

namespace app {

/// Extremes and means of lines and propellers over all steps of a run, not only logged times.
class RigTotals {
 public:
  /// True if the simulation has something to sum up.
  static bool sums_up(const engine::SimulationSpec& spec) {
    return !spec.lines.empty() || spec.moordyn || !spec.propellers.empty();
  }

  /// Adds the readings after a step, or those of the start.
  void add(double time, const engine::RigReadings& readings);

  /// Everything that was added, for a checkpoint. Numbers are read back to the same.
  nlohmann::ordered_json state() const;
  /// @throws nlohmann::json::exception unless `state` is that of state().
  void restore(const nlohmann::ordered_json& state);

  /// The entry `lines` of summary.json: of each line `tension_max` [N], its time `at` [s], and
  /// `broken_at` [s], null if it holds.
  nlohmann::ordered_json lines(const engine::SimulationSpec& spec) const;

  /// The entry `machines`: of each propeller `power_mean` [W], the mean of 2π n Q over the steps,
  /// and `thrust_mean` [N]. Foils have no entry.
  nlohmann::ordered_json machines(const engine::SimulationSpec& spec) const;

 private:
  struct Line {
    void add(double time, const engine::LineReading& reading);

    double most = 0;               ///< Largest tension so far [N]; 0 for a line that never pulled.
    double at = 0;                 ///< Its time [s].
    std::optional<double> broken;  ///< Time of the first reading as a broken line [s].
  };
  struct Propeller {
    double power = 0;   ///< Sum over the readings [W].
    double thrust = 0;  ///< [N]
  };
  long readings_ = 0;
  std::vector<Line> lines_;
  std::vector<Propeller> propellers_;
};

}  // namespace app
