#include "app/pages/motion_columns.h"

#include <cmath>
#include <numbers>

#include "hydro/statics/equilibrium.h"

namespace app {
namespace {

/// Removes the jumps by a whole turn from a series of angles [deg].
void unwrap(std::vector<double>& degrees) {
  constexpr double kTurn = 360;
  for (std::size_t i = 1; i < degrees.size(); ++i)
    degrees[i] -= kTurn * std::round((degrees[i] - degrees[i - 1]) / kTurn);
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
  for (std::size_t i = 0; i < rows; ++i) {
    const hydro::BodyState& s = track.states[i];
    put(0, i, s.position);
    put(3, i, hydro::euler_angles(s.orientation) * (180 / std::numbers::pi));
    put(6, i, s.linear_velocity);
    put(9, i, s.angular_velocity);
  }
  for (std::size_t k = 3; k < 6; ++k) unwrap(columns[k]);
  return columns;
}

}  // namespace app
