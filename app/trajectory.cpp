#include "app/trajectory.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "app/faults.h"
#include "app/log_rows.h"

namespace app {
namespace {

constexpr std::string_view kHeader = "time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz";
constexpr double kUnitTolerance = 0.01;  ///< Of quaternions that others wrote with few digits.

std::array<double, 13> numbers(const hydro::BodyState& s) {
  const Eigen::Vector3d& p = s.position;
  const Eigen::Quaterniond& q = s.orientation;
  const Eigen::Vector3d& v = s.linear_velocity;
  const Eigen::Vector3d& w = s.angular_velocity;
  return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(),
          v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
}

hydro::BodyState state(const std::array<double, 13>& n) {
  return {.position = {n[0], n[1], n[2]},
          .orientation = Eigen::Quaterniond(n[3], n[4], n[5], n[6]),
          .linear_velocity = {n[7], n[8], n[9]},
          .angular_velocity = {n[10], n[11], n[12]}};
}

/// One row; a body's times must ascend.
void read_row(std::string_view text, const std::filesystem::path& file, int line,
              Trajectory& trajectory) {
  std::array<double, 13> values;
  const LogRow row = read_log_row(text, file, line, values);
  const double time = row.time;
  const std::string name(row.body);
  const auto [entry, is_new] = trajectory.tracks.try_emplace(name);
  BodyTrack& track = entry->second;
  if (is_new) trajectory.names.push_back(name);
  if (!track.times.empty() && time <= track.times.back())
    refuse_row(
        file, line,
        fmt::format("time {} of body {} does not come after {}", time, name, track.times.back()));
  track.times.push_back(time);
  track.states.push_back(state(values));
  const double norm = track.states.back().orientation.norm();
  if (!(std::abs(norm - 1) < kUnitTolerance))
    refuse_row(file, line, fmt::format("the quaternion has length {:g}, expected 1", norm));
}

}  // namespace

TrajectoryWriter::TrajectoryWriter(const std::filesystem::path& file,
                                   std::vector<std::string> names)
    : names_(std::move(names)), file_(file, kHeader) {}

void TrajectoryWriter::add(double time, const std::vector<hydro::BodyState>& states) {
  fmt::memory_buffer rows;
  for (std::size_t i = 0; i < states.size(); ++i) {
    fmt::format_to(std::back_inserter(rows), "{},{}", time, names_[i]);
    for (const double n : numbers(states[i])) fmt::format_to(std::back_inserter(rows), ",{}", n);
    rows.push_back('\n');
  }
  file_.add(rows);
}

Trajectory read_trajectory(const std::filesystem::path& file) {
  Trajectory trajectory;
  const auto read = [&](std::string_view row, int line) { read_row(row, file, line, trajectory); };
  read_log(file, kHeader, "a trajectory", read);
  if (trajectory.names.empty()) throw InputError(file, "has no rows");
  return trajectory;
}

}  // namespace app
