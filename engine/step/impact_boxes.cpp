#include "engine/step/impact_boxes.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "engine/base/constants.h"

namespace engine {
namespace {

/// A bound of the speed of each body after impacts [m/s]; none for one that nothing fast hits.
using ThrownSpeeds = std::vector<std::optional<double>>;

bool moves(const StepContext& context, std::size_t i) {
  return i < context.bodies.size() && context.bodies[i].body.movable;
}

Eigen::Vector3d velocity_of(const StepContext& context, std::size_t i) {
  if (!moves(context, i)) return Eigen::Vector3d::Zero();
  return context.bodies[i].motion.state.linear_velocity;
}

/// A bound of the relative speed of a pair [m/s].
double closing_speed(const StepContext& context, const ThrownSpeeds& thrown, const BoxPair& pair) {
  const auto& [a, b] = pair;
  const Eigen::Vector3d first = velocity_of(context, a), second = velocity_of(context, b);
  const auto has_been_hit = [&](std::size_t i) { return i < thrown.size() && thrown[i]; };
  if (!has_been_hit(a) && !has_been_hit(b)) return (first - second).norm();
  return (has_been_hit(a) ? *thrown[a] : first.norm()) +
         (has_been_hit(b) ? *thrown[b] : second.norm());
}

/// Thickness of the thinner body of a pair [m].
double thickness(const StepContext& context, const BoxPair& pair) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : {pair.first, pair.second})
    if (i < context.bodies.size())
      least = std::min(least, context.world.shape_box(static_cast<BodyId>(i)).sizes().minCoeff());
  return least;
}

/// The speed of one body after an elastic impact at another, in which it closes that fast [m/s].
double speed_after(const StepContext& context, std::size_t one, std::size_t other, double closing) {
  const double own = velocity_of(context, one).norm();
  if (!moves(context, other)) return own;
  const double mass = context.bodies[one].body.spec->mass;
  const double other_mass = context.bodies[other].body.spec->mass;
  return own + 2 * other_mass / (mass + other_mass) * closing;
}

/// The bounds after the impacts of all fast pairs. The bounds before stay where there are any.
ThrownSpeeds after_impacts(const StepContext& context, double step, const ThrownSpeeds& before,
                           const std::vector<BoxPair>& pairs) {
  ThrownSpeeds after(before.size());
  for (const BoxPair& pair : pairs) {
    const double closing = closing_speed(context, before, pair);
    if (closing * step <= kFarImpact * thickness(context, pair)) continue;
    for (const auto& [one, other] : {pair, BoxPair(pair.second, pair.first)})
      if (moves(context, one))
        after[one] = std::max(after[one].value_or(0), speed_after(context, one, other, closing));
  }
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i]) after[i] = before[i];
  return after;
}

/// The places of a body that has this speed at most.
Eigen::AlignedBox3d box_of_thrown(const StepContext& context, double step, std::size_t i,
                                  double speed) {
  const Eigen::AlignedBox3d& shape_B = context.world.shape_box(static_cast<BodyId>(i));
  const Eigen::Vector3d& position = context.bodies[i].motion.state.position;
  const double radius = shape_B.center().norm() + shape_B.diagonal().norm() / 2;
  const double far = radius + step * (speed + context.gravity * step);
  return {position.array() - far, position.array() + far};
}

}  // namespace

std::vector<BoxPair> with_impacts(const StepContext& context, double step,
                                  std::vector<Eigen::AlignedBox3d> boxes,
                                  std::vector<BoxPair> pairs) {
  ThrownSpeeds thrown(context.bodies.size());
  for (int round = 0; round < kImpactRounds; ++round) {
    ThrownSpeeds after = after_impacts(context, step, thrown, pairs);
    if (after == thrown) break;
    thrown = std::move(after);
    for (std::size_t i = 0; i < thrown.size(); ++i)
      if (thrown[i]) boxes[i].extend(box_of_thrown(context, step, i, *thrown[i]));
    pairs = overlapping(boxes);
  }
  return pairs;
}

}  // namespace engine
