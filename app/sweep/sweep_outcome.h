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
/// What one run of a sweep came to, the file that keeps it, and the table of them all.

namespace app {

/// Columns of a body, after its name and a dot. First its last state as in a trajectory, then, over
/// all logged rows: lowest and highest z [m], greatest speed [m/s] and angular speed [rad/s],
/// greatest acceleration [m/s^2] (the change of velocity from a row to the next over the time
/// between), last and greatest tilt [deg] (the angle of the body's z axis to the vertical).
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
  std::array<double, kBodyColumns.size()> values = {};  ///< As kBodyColumns.
};

/// The last and extreme values of a track of at least one row.
BodyOutcome body_outcome(const std::string& name, const BodyTrack& track);

struct RunOutcome {
  int code = 0;                     ///< Exit code of `run`; 128 and the signal that ended it.
  std::optional<double> simulated;  ///< [s]; none if the run did not begin.
  double wall = 0;                  ///< Of the whole process [s].
  std::string message;              ///< The error, else the warnings.
  std::vector<BodyOutcome> bodies;  ///< Of the trajectory as far as it goes.
};

/// What a run that has ended left in its folder.
/// @param messages   File of what it said.
RunOutcome collect_outcome(const std::filesystem::path& folder,
                           const std::filesystem::path& messages, int code, double wall);

/// Writes the file whole or not at all. @throws std::runtime_error if it cannot be written
void write_outcome(const RunOutcome& outcome, const std::filesystem::path& file);

/// None if there is no such file, or none of ours.
std::optional<RunOutcome> read_outcome(const std::filesystem::path& file);

/// The table as CSV: a row a run that has an outcome, in the order of the runs.
/// @param points    Of each run. @param bodies   Names, in the order of their columns.
std::string table_of(const std::vector<SweepParameter>& parameters,
                     const std::vector<SweepPoint>& points, const std::vector<std::string>& bodies,
                     const std::vector<std::optional<RunOutcome>>& outcomes);

/// The number of a run as text: `0007`, also the name of its folder.
std::string run_name(std::size_t index);

}  // namespace app
