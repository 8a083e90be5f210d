#include "engine/step/step_controller.h"

#include <algorithm>
#include <cmath>

namespace engine {

double estimated_error(const Body& body, const Motion& whole, const Motion& halves, double h,
                       double tolerance) {
  const hydro::BodyState& a = whole.state;
  const hydro::BodyState& b = halves.state;
  const double radius = std::max(body.box_B.sizes().norm() / 2, 1e-9);
  const Eigen::Vector3d turn = (a.orientation * b.orientation.conjugate()).vec();
  const double difference = std::max({(a.position - b.position).norm() / radius, 2 * turn.norm(),
                                      h * (a.linear_velocity - b.linear_velocity).norm() / radius,
                                      h * (a.angular_velocity - b.angular_velocity).norm()});
  return difference / 3 / (tolerance * h);
}

double length_for_error(double h, double error) {
  return h * std::clamp(0.9 / std::sqrt(std::max(error, 1e-12)), 0.25, 4.0);
}

}  // namespace engine
