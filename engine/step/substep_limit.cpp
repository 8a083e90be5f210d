#include "engine/step/substep_limit.h"

#include <algorithm>
#include <cmath>

#include "engine/base/constants.h"
#include "engine/motion/energy.h"
#include "engine/motion/free_motion.h"

namespace engine {
namespace {

/// Length of the fewest equal parts of `rest` that are no longer than `longest`.
double equal_part(double rest, double longest) {
  return rest / std::max(1.0, std::ceil(rest / longest));
}

/// Limit by the turn of a wet body and by its rise through the water surface.
double crossing_limit(const Body& body, const Motion& motion, double rest, double shortest) {
  if (!body.wet) return rest;
  const hydro::BodyState& state = motion.state;
  const auto [low, height] = vertical_extent(body, state);
  const double rise = state.linear_velocity.z() * rest;
  // A body that turns about a fixed point may move in any direction within the step.
  const bool turns = body.reduced_joint && body.reduced_joint->turns();
  const double round = turns ? state.linear_velocity.norm() * rest : 0;
  if (std::min(low, low + rise) - round >= body.environment.highest) return rest;
  double rate = state.angular_velocity.norm() / kLargestWetTurn;
  if (std::max(low, low + rise) + height > body.environment.lowest)
    rate = std::max(rate, std::abs(state.linear_velocity.z()) / (kLargestCrossing * height));
  return equal_part(rest, std::max(shortest, rate > 0 ? 1 / rate : rest));
}

/// Limit by an oscillation that the last accelerations resolve.
double swing_limit(const Body& body, const Motion& motion, double rest, double shortest) {
  const double frequency = motion.accelerations.dominant_frequency();
  if (!body.wet || frequency * rest <= kLargestSwing) return rest;
  const Eigen::Vector3d a = motion.accelerations.expected(0).head<3>();
  if (a.norm() * rest * rest < kSmallestSwing * body.radius) return rest;
  return equal_part(rest, std::max(shortest, kLargestSwing / frequency));
}

/// Rate at which a body and its momentum turn by its own inertia and that of the water [rad/s].
double own_turning_rate(const Body& body, const Motion& motion) {
  const Eigen::Matrix3d R_BW = motion.state.orientation.conjugate().toRotationMatrix();
  return turning_rate(body.rigid_B + motion.added(),
                      rotate(R_BW, velocity(motion.state, body.current())), motion.rotors_B);
}

double turn_limit(const Body& body, const Motion& motion, double rest, double shortest) {
  double rate = own_turning_rate(body, motion);
  if (body.driven_by_rows) rate = std::max(rate, motion.state.angular_velocity.norm());
  return equal_part(rest, std::max(shortest, rate > 0 ? kLargestConstrainedTurn / rate : rest));
}

}  // namespace

SurfaceCrossing surface_crossing(const Body& body, const hydro::BodyState& before,
                                 const hydro::BodyState& after) {
  const double first = vertical_extent(body, before).lowest;
  const auto [last, height] = vertical_extent(body, after);
  return {.meets = std::min(first, last) < body.environment.highest &&
                   std::max(first, last) + height > body.environment.lowest,
          .reaches = std::max(first, last) >= body.environment.highest,
          .rise = last - first,
          .height = height};
}

double substep_limit(const Body& body, const Motion& motion, double rest, double step,
                     bool constrained) {
  const double shortest = step / kMostSubsteps;
  const double own = constrained ? turn_limit(body, motion, rest, shortest)
                                 : swing_limit(body, motion, rest, kShortestSwing * step);
  return std::min(own, crossing_limit(body, motion, rest, shortest));
}

bool can_be_followed(const Body& body, const Motion& motion, double h) {
  return own_turning_rate(body, motion) * h < kFollowedTurn;
}

bool is_smooth(const AccelerationHistory& history, double h) {
  return history.resolved() && history.dominant_frequency() * h <= kSmoothSwing;
}

bool SurfaceCrossing::abrupt() const {
  return meets && (reaches || std::abs(rise) > kAbruptCrossing * height);
}

bool crosses_surface(const Body& body, const hydro::BodyState& before,
                     const hydro::BodyState& after) {
  return surface_crossing(body, before, after).abrupt();
}

bool added_mass_jumps(const Body& body, const Motion& before, const Motion& after) {
  if (!before.added_B && !after.added_B) return false;
  const Matrix6d change = after.added() - before.added();
  return scaled_change(body, before.added(), change) > kLargestAddedChange;
}

bool overshoots_surface(const Body& body, const hydro::BodyState& before,
                        const hydro::BodyState& after, double h) {
  const SurfaceCrossing c = surface_crossing(body, before, after);
  // Not by the velocity at the end, which the water slows that moves with the body there.
  const Eigen::Vector3d path = after.position - before.position;
  const Eigen::Vector3d thrown = path - h * before.linear_velocity;
  return c.meets && std::min(path.norm(), thrown.norm()) > kLargestOvershoot * c.height;
}

}  // namespace engine
