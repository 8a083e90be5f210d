#include "engine/impacts.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "engine/constants.h"
#include "engine/passing.h"

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
      slow_(impact_speed(context.gravity)) {
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
  const bool resolved = touching.size() <= kMostImpactPairs && count_ < kMostImpacts;
  const std::vector<Onset> found = onsets(h, resolved);
  if (found.empty()) return std::nullopt;
  if (resolved) ++count_;
  const double start =
      std::min_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return a.time < b.time;
      })->time;
  double first = first_;
  for (const Onset& onset : found) {
    if (onset.time > start + begun_) continue;
    will_touch_.push_back(onset.pair);
    first = std::min(first, onset.first);
    for (const BodyId id : {onset.pair.first, onset.pair.second}) {
      if (!can_move(context_->bodies, id)) continue;
      double& longest = body(id).motion.longest_after_impact;
      longest = std::min(longest, onset.first);
    }
  }
  return start > kImpactBegun * first ? start : std::min(h, first);
}

std::vector<Impacts::Onset> Impacts::onsets(double h, bool resolved) {
  std::vector<Onset> found;
  bool passes = false;
  const int most = kMostPassings * static_cast<int>(group_->bodies.size());
  for (const Pair& pair : group_->near) {
    const Speed speed = meeting_speed(pair);
    if (!(speed.linear > slow_)) continue;
    const double reach = context_->world.reach(pair);
    std::optional<double> time;
    if (resolved) time = onset(pair, h);
    if (!time && speed.linear * h > reach && passings_ < most) {
      time = passing(pair, h, speed, reach);
      passes = passes || time;
    }
    if (time)
      found.push_back(
          {.time = *time, .first = std::min(first_, reach / speed.linear), .pair = pair});
  }
  passings_ += passes;
  return found;
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

Impacts::Speed Impacts::meeting_speed(const Pair& pair) const {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  double turning = 0, angular = 0;
  for (const BodyId id : {pair.first, pair.second}) {
    if (!can_move(context_->bodies, id)) continue;
    const hydro::BodyState& state = body(id).motion.state;
    velocity = state.linear_velocity - velocity;
    turning += body(id).body.radius * state.angular_velocity.norm();
    angular += state.angular_velocity.norm();
  }
  return {.linear = velocity.norm() + turning, .angular = angular};
}

std::optional<double> Impacts::passing(const Pair& pair, double h, const Speed& speed,
                                       double reach) const {
  const auto state = [this](BodyId id, double time) {
    if (can_move(context_->bodies, id)) return expected_state(body(id), time);
    return id == kWorld ? hydro::BodyState{} : context_->world.state(id);
  };
  const auto time = unseen_contact(context_->world, {.pair = pair,
                                                     .h = h,
                                                     .speed = speed.linear,
                                                     .turning = speed.angular,
                                                     .reach = reach,
                                                     .slow = slow_,
                                                     .state = state});
  const bool met = std::binary_search(touching_.begin(), touching_.end(), pair);
  if (met && time == 0.0) return std::nullopt;  // their contact stops them
  return time;
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
