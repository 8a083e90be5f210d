#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/logs/trajectory.h"
#include "app/sweep/sweep_parameters.h"

/// @file
/// Outcome of a run of a sweep, the file that stores it, and the table of all outcomes.

namespace app {

/// Columns of a body, prefixed by its name and a dot: its last state as in a trajectory, then over
/// all logged rows the lowest and highest z [m], the greatest speed [m/s], angular speed [rad/s]
/// and acceleration [m/s^2] (the difference quotient of the velocity between rows), the last and
/// the greatest tilt [deg] (the angle of the body's z axis to the vertical).
inline constexpr std::array<std::string_view, 20> kBodyColumns = {"x",
                                                                  "y",
                                                                  "z",
                                                                  "qw",
                                                                  "qx",
                                                                  "qy",
                                                                  "qz",
                                                                  "vx",
                                                                  "vy",
                                                                  "vz",
                                                                  "wx",
                                                                  "wy",
                                                                  "wz",
                                                                  "z_min",
                                                                  "z_max",
                                                                  "speed_max",
                                                                  "angular_speed_max",
                                                                  "acceleration_max",
                                                                  "tilt_deg",
                                                                  "tilt_max_deg"};

struct BodyOutcome {
  std::string name;
  std::array<double, kBodyColumns.size()> values = {};  ///< Values in the order of kBodyColumns.
};

/// Returns the last and extreme values of a track of at least one row.
BodyOutcome body_outcome(const std::string& name, const BodyTrack& track);

/// Columns of a hinge or slider, prefixed by `joints.`, its name and a dot, as far as its entry in
/// summary.json has them (app/run/rig_totals.h).
inline constexpr std::array<std::string_view, 5> kJointColumns = {
    "stroke", "power_mean", "power_max", "effort_rms", "effort_max"};

/// A number and its column.
struct NamedNumber {
  std::string column;
  double value = 0;
};

struct RunOutcome {
  int code = 0;                          ///< Exit code of `run`, or 128 + the signal that ended it.
  std::optional<double> simulated;       ///< [s]; none if the run did not begin.
  double wall = 0;                       ///< Wall time of the whole process [s].
  std::string message;                   ///< Error message, or else the warnings.
  std::vector<BodyOutcome> bodies;       ///< Outcomes of the trajectory as far as it was written.
  std::vector<NamedNumber> joints = {};  ///< Numbers of kJointColumns.
};

/// Collects the outcome of a run from its folder.
/// @param messages   File with its messages.
RunOutcome collect_outcome(const std::filesystem::path& folder,
                           const std::filesystem::path& messages, int code, double wall);

/// Writes the file whole or not at all. @throws std::runtime_error if it cannot be written
void write_outcome(const RunOutcome& outcome, const std::filesystem::path& file);

/// Returns none if there is no such file, or if it holds no outcome.
std::optional<RunOutcome> read_outcome(const std::filesystem::path& file);

/// Returns the table as CSV with a row for each run that has an outcome, in the order of the runs.
/// The columns of joints are the last, in the order in which the runs first have them.
/// @param points   Values of each run. @param bodies   Names, in the order of their columns.
std::string table_of(const std::vector<SweepParameter>& parameters,
                     const std::vector<SweepPoint>& points, const std::vector<std::string>& bodies,
                     const std::vector<std::optional<RunOutcome>>& outcomes);

/// Returns the number of a run as text, also the name of its folder: `0007`.
std::string run_name(std::size_t index);

}  // namespace app
