#include "engine/applied_load.h"

#include <cmath>
#include <numbers>

namespace engine {
namespace {

/// True if the load acts. A multiple of the step differs from the time as written by round-off.
bool acts(const AppliedLoad& load, double time) {
  const double later = time + 1e-12 * std::abs(time);
  return later >= load.start && later < load.end;
}

}  // namespace

hydro::Wrench wrench(const AppliedLoad& load, const hydro::BodyState& state, double time) {
  if (!acts(load, time)) return {};
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const Eigen::Vector3d force = load.in_body_frame ? R_WB * load.force : load.force;
  const Eigen::Vector3d torque = load.in_body_frame ? R_WB * load.torque : load.torque;
  const hydro::Wrench whole{.force = force, .moment = torque + (R_WB * load.at_B).cross(force)};
  if (!load.sine) return whole;
  return std::sin(2 * std::numbers::pi * load.sine->frequency * time + load.sine->phase) * whole;
}

}  // namespace engine
