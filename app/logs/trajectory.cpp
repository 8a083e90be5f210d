#include "app/logs/trajectory.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "app/logs/hdf5_log.h"
#include "app/logs/log.h"
#include "app/logs/log_rows.h"
#include "app/scene/faults.h"

namespace app {
namespace {

constexpr std::string_view kHeader = "time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz";
constexpr double kUnitTolerance = 0.01;  ///< Of quaternions that others wrote with few digits.

/// One row; a body's times must ascend.
void read_row(std::string_view text, const std::filesystem::path& file, int line,
              Trajectory& trajectory) {
  StateRow values;
  const LogRow row = read_log_row(text, file, line, values);
  const std::string name(row.body);
  const auto [entry, is_new] = trajectory.tracks.try_emplace(name);
  if (is_new) trajectory.names.push_back(name);
  const std::string fault = add_row(name, row.time, values, entry->second);
  if (!fault.empty()) refuse_row(file, line, fault);
}

/// CSV.
Trajectory read_rows(const std::filesystem::path& file) {
  Trajectory trajectory;
  const auto read = [&](std::string_view row, int line) { read_row(row, file, line, trajectory); };
  read_log(file, kHeader, "a trajectory", read);
  return trajectory;
}

}  // namespace

StateRow row_of(const hydro::BodyState& s) {
  const Eigen::Vector3d& p = s.position;
  const Eigen::Quaterniond& q = s.orientation;
  const Eigen::Vector3d& v = s.linear_velocity;
  const Eigen::Vector3d& w = s.angular_velocity;
  return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(),
          v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
}

hydro::BodyState state_of(const StateRow& n) {
  return {.position = {n[0], n[1], n[2]},
          .orientation = Eigen::Quaterniond(n[3], n[4], n[5], n[6]),
          .linear_velocity = {n[7], n[8], n[9]},
          .angular_velocity = {n[10], n[11], n[12]}};
}

std::string add_row(const std::string& name, double time, const StateRow& row, BodyTrack& track) {
  if (!track.times.empty() && time <= track.times.back())
    return fmt::format("time {} of body {} does not come after {}", time, name, track.times.back());
  track.times.push_back(time);
  track.states.push_back(state_of(row));
  const double norm = track.states.back().orientation.norm();
  if (!(std::abs(norm - 1) < kUnitTolerance))
    return fmt::format("the quaternion has length {:g}, expected 1", norm);
  return "";
}

TrajectoryWriter::TrajectoryWriter(const std::filesystem::path& file,
                                   std::vector<std::string> names)
    : names_(std::move(names)), file_(file, kHeader) {}

void TrajectoryWriter::add(double time, const std::vector<hydro::BodyState>& states) {
  fmt::memory_buffer rows;
  for (std::size_t i = 0; i < states.size(); ++i) {
    fmt::format_to(std::back_inserter(rows), "{},{}", time, names_[i]);
    for (const double n : row_of(states[i])) fmt::format_to(std::back_inserter(rows), ",{}", n);
    rows.push_back('\n');
  }
  file_.add(rows);
}

std::filesystem::path trajectory_of(const std::filesystem::path& given) {
  if (!std::filesystem::is_directory(given)) return given;
  const bool hdf5 = std::filesystem::exists(given / kHdf5Log);
  return given / (hdf5 ? kHdf5Log : kTrajectoryLog);
}

Trajectory read_trajectory(const std::filesystem::path& file) {
  Trajectory trajectory = is_hdf5(file) ? read_hdf5_log(file) : read_rows(file);
  if (trajectory.names.empty()) throw InputError(file, "has no rows");
  return trajectory;
}

}  // namespace app
