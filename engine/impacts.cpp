#include "engine/impacts.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "engine/constants.h"

namespace engine {
namespace {

/// The state after `time` [s] by drift and the extrapolated acceleration.
hydro::BodyState expected_state(const MovingBody& moving, double time) {
  hydro::BodyState state =
      state_after_drift(moving.body, moving.motion, moving.body.current(), time);
  const Vector6d acceleration_B = moving.motion.accelerations.expected(time / 2);
  state.position += time * time / 2 * (state.orientation * acceleration_B.head<3>());
  return state;
}

}  // namespace

Impacts::Impacts(const StepContext& context, const Group& group, const std::vector<Pair>& touching,
                 double step)
    : context_(&context),
      group_(&group),
      first_(kFirstAfterImpact * std::min(step, kShortestContact)),
      begun_(kImpactBegun * first_),
      step_(step),
      slow_(kShortestContact * std::max(context.gravity, kLeastGravity)) {
  std::set_intersection(group.near.begin(), group.near.end(), touching.begin(), touching.end(),
                        std::back_inserter(touching_));
}

double Impacts::longest_substep() const {
  double longest = std::numeric_limits<double>::infinity();
  for (const BodyId id : group_->bodies)
    longest = std::min(longest, body(id).motion.longest_after_impact);
  return longest;
}

std::optional<double> Impacts::next(double h, const std::vector<Pair>& touching) {
  if (touching.size() > kMostImpactPairs || count_ == kMostImpacts) return std::nullopt;
  std::vector<std::pair<double, Pair>> onsets;
  for (const Pair& pair : group_->near) {
    if (!may_meet_fast(pair)) continue;
    const auto time = onset(pair, h);
    if (time) onsets.emplace_back(*time, pair);
  }
  if (onsets.empty()) return std::nullopt;
  ++count_;
  const double first = std::min_element(onsets.begin(), onsets.end())->first;
  for (const auto& [time, pair] : onsets) {
    if (time > first + begun_) continue;
    will_touch_.push_back(pair);
    for (const BodyId id : {pair.first, pair.second})
      if (can_move(context_->bodies, id)) body(id).motion.longest_after_impact = first_;
  }
  return first > begun_ ? first : std::min(h, first_);
}

void Impacts::accept(const std::vector<Pair>& touching) {
  touching_.clear();
  std::set_union(touching.begin(), touching.end(), will_touch_.begin(), will_touch_.end(),
                 std::back_inserter(touching_));
  will_touch_.clear();
  for (const BodyId id : group_->bodies) {
    double& longest = body(id).motion.longest_after_impact;
    longest = longest < step_ ? kImpactGrowth * longest : std::numeric_limits<double>::infinity();
  }
}

bool Impacts::may_meet_fast(const Pair& pair) const {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  double turning = 0;
  for (const BodyId id : {pair.first, pair.second}) {
    if (!can_move(context_->bodies, id)) continue;
    const hydro::BodyState& state = body(id).motion.state;
    velocity = state.linear_velocity - velocity;
    turning += body(id).body.radius * state.angular_velocity.norm();
  }
  return velocity.norm() + turning > slow_;
}

std::optional<double> Impacts::onset(const Pair& pair, double time) const {
  const bool met = std::binary_search(touching_.begin(), touching_.end(), pair);
  std::optional<double> found;
  for (int i = 0; i < kMostOnsetLooks; ++i) {
    std::vector<std::pair<BodyId, hydro::BodyState>> places;
    for (const BodyId id : {pair.first, pair.second})
      if (can_move(context_->bodies, id)) places.emplace_back(id, expected_state(body(id), time));
    std::optional<double> earliest;
    for (const double since : context_->world.closing_times(places, pair, slow_)) {
      const double start = time - since;
      if (met && start < begun_) continue;  // that one is over
      earliest = std::max(0.0, std::min(start, earliest.value_or(start)));
    }
    if (!earliest) return found;
    found = time = *earliest;
  }
  return found;
}

}  // namespace engine
