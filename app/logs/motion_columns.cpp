#include "app/logs/motion_columns.h"

#include <cmath>
#include <numbers>

#include "hydro/statics/equilibrium.h"

namespace app {
namespace {

/// Returns angles [deg] moved by whole turns to the nearest of those before.
Eigen::Vector3d near(Eigen::Vector3d degrees, const Eigen::Vector3d& before) {
  constexpr double kTurn = 360;
  return degrees - kTurn * ((degrees - before) / kTurn).array().round().matrix();
}

/// Returns roll, pitch and yaw [deg] of the same attitude nearest to those before: the pitch may
/// pass the vertical, where the other two would otherwise jump by half a turn.
Eigen::Vector3d unwrapped(const Eigen::Vector3d& degrees, const Eigen::Vector3d& before) {
  const Eigen::Vector3d same = near(degrees, before);
  const Eigen::Vector3d over =
      near({degrees.x() + 180, 180 - degrees.y(), degrees.z() + 180}, before);
  return (over - before).norm() < (same - before).norm() ? over : same;
}

}  // namespace

const std::vector<std::string>& motion_columns() {
  static const std::vector<std::string> names = {"x",  "y",  "z",  "roll", "pitch", "yaw",
                                                 "vx", "vy", "vz", "wx",   "wy",    "wz"};
  return names;
}

std::vector<std::vector<double>> motion_of(const BodyTrack& track) {
  const std::size_t rows = track.states.size();
  std::vector<std::vector<double>> columns(motion_columns().size(), std::vector<double>(rows));
  const auto put = [&](std::size_t first, std::size_t row, const Eigen::Vector3d& v) {
    for (std::size_t k = 0; k < 3; ++k) columns[first + k][row] = v[static_cast<int>(k)];
  };
  Eigen::Vector3d angles = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < rows; ++i) {
    const hydro::BodyState& s = track.states[i];
    put(0, i, s.position);
    const Eigen::Vector3d found = hydro::euler_angles(s.orientation) * (180 / std::numbers::pi);
    put(3, i, angles = i == 0 ? found : unwrapped(found, angles));
    put(6, i, s.linear_velocity);
    put(9, i, s.angular_velocity);
  }
  return columns;
}

void start_alike(const std::vector<std::vector<double>>& other,
                 std::vector<std::vector<double>>& motion) {
  constexpr double kTurn = 360;
  for (std::size_t k = 3; k < 6; ++k) {
    const double shift = kTurn * std::round((other[k].front() - motion[k].front()) / kTurn);
    for (double& angle : motion[k]) angle += shift;
  }
}

}  // namespace app
