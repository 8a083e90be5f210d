#include "app/held/motions.h"

#include <algorithm>

namespace app {
namespace {

double* put(const Eigen::Vector3d& vector, double* place) {
  return std::copy_n(vector.data(), 3, place);
}

}  // namespace

MotionArrays::MotionArrays(std::size_t simulations, std::size_t bodies)
    : bodies_(bodies),
      time_(simulations),
      position_(3 * simulations * bodies),
      orientation_(4 * simulations * bodies),
      velocity_(3 * simulations * bodies),
      angular_velocity_(3 * simulations * bodies) {}

MotionRows MotionArrays::rows(std::size_t simulation) {
  const std::size_t first = simulation * bodies_;
  return {.time = &time_[simulation],
          .position = position_.data() + 3 * first,
          .orientation = orientation_.data() + 4 * first,
          .velocity = velocity_.data() + 3 * first,
          .angular_velocity = angular_velocity_.data() + 3 * first};
}

void write(double time, const std::vector<hydro::BodyState>& states, const MotionRows& rows) {
  MotionRows row = rows;
  *row.time = time;
  for (const hydro::BodyState& state : states) {
    row.position = put(state.position, row.position);
    *row.orientation++ = state.orientation.w();
    row.orientation = put(state.orientation.vec(), row.orientation);
    row.velocity = put(state.linear_velocity, row.velocity);
    row.angular_velocity = put(state.angular_velocity, row.angular_velocity);
  }
}

}  // namespace app
