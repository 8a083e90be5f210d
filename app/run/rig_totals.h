#pragma once

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "app/logs/rig_log.h"
#include "engine/base/rig_readings.h"
#include "engine/base/spec.h"

namespace app {

/// Extremes and means of lines, propellers and the drives of joints over all steps of a run, not
/// only logged times.
class RigTotals {
 public:
  /// True if the simulation has something to sum up.
  static bool sums_up(const engine::SimulationSpec& spec) {
    return !spec.lines.empty() || !spec.propellers.empty() ||
           std::ranges::any_of(spec.joints, has_coordinate);
  }

  /// Adds the readings after a step, or those of the start.
  void add(double time, const engine::SimulationSpec& spec, const engine::RigReadings& readings);

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

  /// Entries of a hinge or slider for `joints`: `stroke`, the range of its coordinate [rad, m];
  /// with a damper, spring or motor `power_mean` and `power_max` [W], the mean over time and the
  /// largest over a step of the power that they absorb together, and `effort_rms` and `effort_max`
  /// [N m, N] of their effort along the coordinate; and an object with these four of each,
  /// `damper`, `spring` and `motor`. A damper absorbs positive power, a motor that drives negative.
  /// Empty for other joints. @param joint   Its index.
  nlohmann::ordered_json joint(const engine::SimulationSpec& spec, std::size_t joint) const;

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
  /// Power and effort of a part of a joint's drive.
  struct Part {
    /// Adds a step: the energy absorbed, and the mean square and the size of the effort.
    void add(double energy, double mean_square, double most, double interval);
    /// @param seconds   Duration of all steps.
    nlohmann::ordered_json json(double seconds) const;
    nlohmann::ordered_json state() const;
    void restore(const nlohmann::ordered_json& state);

    long steps = 0;
    double work = 0;     ///< Energy absorbed [J].
    double power = 0;    ///< Largest power over a step [W].
    double square = 0;   ///< Integral of the squared effort over time [N² s, (N m)² s].
    double largest = 0;  ///< Largest size of the effort [N, N m].
  };
  struct Joint {
    void begin(const engine::JointReading& now);
    void add(const engine::JointReading& now, bool turns, double interval);

    double least = 0, most = 0;         ///< Range of the coordinate [rad, m].
    double coordinate = 0;              ///< The latest, counted on over full turns.
    std::array<double, 4> latest = {};  ///< Coordinate, speed, damper and spring as read last.
    Part all, of_damper, of_spring, of_motor;
  };
  double start_ = 0, latest_ = 0;  ///< Times of the first and of the latest reading [s].
  std::vector<Joint> joints_;
  long readings_ = 0;
  std::vector<Line> lines_;
  std::vector<Propeller> propellers_;
};

}  // namespace app
