#include "engine/base/body_quantity.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace engine {
namespace {

using Eigen::Vector3d;
using Quantity = Measurement::Quantity;

/// Heading, pitch or roll of the body's axes: those of R = R_z(heading) R_y(pitch) R_x(roll).
double attitude(Quantity quantity, const Eigen::Quaterniond& q) {
  const Eigen::Matrix3d R = q.toRotationMatrix();
  if (quantity == Quantity::heading) return std::atan2(R(1, 0), R(0, 0));
  if (quantity == Quantity::pitch) return -std::asin(std::clamp(R(2, 0), -1.0, 1.0));
  return std::atan2(R(2, 1), R(2, 2));
}

}  // namespace

double body_quantity(Quantity quantity, const hydro::BodyState& state, double level) {
  switch (quantity) {
    case Quantity::x:
      return state.position.x();
    case Quantity::y:
      return state.position.y();
    case Quantity::z:
      return state.position.z();
    case Quantity::depth:
      return level - state.position.z();
    case Quantity::speed:
      return (state.orientation * Vector3d::UnitX()).dot(state.linear_velocity);
    case Quantity::sway:
      return (state.orientation * Vector3d::UnitY()).dot(state.linear_velocity);
    case Quantity::turn_rate:
      return state.angular_velocity.z();
    case Quantity::heading:
    case Quantity::pitch:
    case Quantity::roll:
      return attitude(quantity, state.orientation);
    default:
      assert(false && "a quantity of a body");
      return 0;
  }
}

}  // namespace engine
