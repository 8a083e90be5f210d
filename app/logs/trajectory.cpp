#include "app/logs/trajectory.h"

#include <fmt/format.h>

#include <cmath>

namespace app {
namespace {

constexpr double kUnitTolerance = 0.01;  ///< Allows for quaternions with few digits.

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

}  // namespace app
