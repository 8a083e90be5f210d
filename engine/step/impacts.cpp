#include "engine/step/impacts.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>

#include "engine/base/constants.h"
#include "engine/step/passing.h"

namespace engine {
namespace {

/// A state after `time` [s] of drift, with the effect of the extrapolated acceleration.
hydro::BodyState with_acceleration(const MovingBody& moving, hydro::BodyState state, double time) {
  const Vector6d acceleration_B = moving.motion.accelerations.expected(time / 2);
  state.position += time * time / 2 * (state.orientation * acceleration_B.head<3>());
  return state;
}

/// The state after `time` [s] by drift and the extrapolated acceleration.
hydro::BodyState expected_state(const MovingBody& moving, double time) {
  return with_acceleration(
      moving, state_after_drift(moving.body, moving.motion, moving.body.current(), time), time);
}

}  // namespace

/// States at any times of a substep. Each follows from the nearest known one before it, so that the
/// drift of a body that spins fast is not repeated as a whole for each of them.
class PredictedStates {
 public:
  explicit PredictedStates(const StepContext& context) : context_(context) {}

  hydro::BodyState state_at(BodyId id, double time) {
    const MovingBody& moving = context_.bodies[id];
    Drift& drift =
        drifts_.try_emplace(id, Drift{moving.motion, {{0, moving.motion.state}}}).first->second;
    const auto after = drift.drifted.upper_bound(time);
    const auto& [known, state] = *std::prev(after);
    if (known < time) {
      drift.motion.state = state;
      const hydro::BodyState drifted =
          state_after_drift(moving.body, drift.motion, moving.body.current(), time - known);
      return with_acceleration(moving, drift.drifted.emplace_hint(after, time, drifted)->second,
                               time);
    }
    return with_acceleration(moving, state, time);
  }

 private:
  struct Drift {
    Motion motion;
    std::map<double, hydro::BodyState> drifted;  ///< By the time from the start of the substep.
  };
  const StepContext& context_;
  std::map<BodyId, Drift> drifts_;
};

Impacts::Impacts(const StepContext& context, const Group& group, const std::vector<Pair>& touching,
                 double step)
    : context_(&context),
      group_(&group),
      first_(kFirstAfterImpact * std::min(step, kShortestContact)),
      begun_(kImpactBegun * first_),
      step_(step),
      slow_(impact_speed(context.gravity)),
      queries_(kMostPassingQueries * static_cast<int>(group.bodies.size())) {
  std::set_intersection(group.near.begin(), group.near.end(), touching.begin(), touching.end(),
                        std::back_inserter(touching_));
}

double Impacts::longest_substep() const {
  double longest = std::numeric_limits<double>::infinity();
  for (const BodyId id : group_->bodies)
    longest = std::min(longest, body(id).motion.longest_after_impact);
  return longest;
}

std::optional<std::vector<Pair>> Impacts::meetings(double h) const {
  const std::vector<Onset> found = onsets(h);
  if (found.empty() && longest_substep() >= h) return std::nullopt;
  std::vector<Pair> pairs;
  for (const Onset& onset : found) pairs.push_back(onset.pair);
  for (const Pair& pair : group_->near)
    if (turned_speed(pair) * h > context_->world.reach(pair)) pairs.push_back(pair);
  return pairs;
}

std::optional<double> Impacts::next(double h, const std::vector<Pair>& touching) {
  const bool resolved = touching.size() <= most_pairs() && count_ < kMostImpacts;
  PredictedStates states(*context_);
  std::vector<Onset> found;
  if (resolved) found = onsets(h);
  const int limit = kMostPassings * static_cast<int>(group_->bodies.size());
  bool passes = passings_ < limit && add_passings(h, states, found);
  if (found.empty()) return std::nullopt;
  // A shorter substep may miss an impact that the contacts halfway through a longer one show.
  double start = earliest(found);
  while (passings_ < limit && add_passings(start, states, found)) {
    start = earliest(found);
    passes = true;
  }
  if (resolved) ++count_;
  passings_ += passes;
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
  std::sort(will_touch_.begin(), will_touch_.end());
  return start > kImpactBegun * first ? start : std::min(h, first);
}

std::size_t Impacts::most_pairs() const {
  return group_->joints.empty() ? kMostImpactPairs : kMostJointedImpactPairs;
}

double Impacts::earliest(const std::vector<Onset>& onsets) {
  return std::ranges::min_element(onsets, {}, &Onset::time)->time;
}

std::vector<Impacts::Onset> Impacts::onsets(double h) const {
  std::vector<Onset> found;
  for (const Pair& pair : group_->near) {
    const Speed speed = meeting_speed(pair);
    if (!(speed.linear > slow_)) continue;
    if (const std::optional<double> time = onset(pair, h))
      found.push_back({.time = *time, .first = first_after(pair, speed), .pair = pair});
  }
  return found;
}

bool Impacts::add_passings(double h, PredictedStates& states, std::vector<Onset>& found) {
  bool adds = false;
  for (const Pair& pair : group_->near) {
    const Speed speed = meeting_speed(pair);
    const double reach = context_->world.reach(pair);
    if (!(speed.linear > slow_) || !(speed.linear * h > reach)) continue;
    const auto known = std::ranges::find(found, pair, &Onset::pair);
    if (known != found.end() && known->time <= h) continue;
    const std::optional<double> time = passing(pair, h, speed, reach, states);
    if (!time) continue;
    adds = true;
    if (known != found.end())
      known->time = *time;
    else
      found.push_back({.time = *time, .first = first_after(pair, speed), .pair = pair});
  }
  return adds;
}

double Impacts::first_after(const Pair& pair, const Speed& speed) const {
  return std::min(first_, context_->world.reach(pair) / speed.linear);
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

double Impacts::turned_speed(const Pair& pair) const {
  double speed = 0;
  for (const BodyId id : {pair.first, pair.second}) {
    if (!can_move(context_->bodies, id)) continue;
    const hydro::BodyState& state = body(id).motion.state;
    speed += state.linear_velocity.norm() + body(id).body.radius * state.angular_velocity.norm();
  }
  return speed;
}

std::optional<double> Impacts::passing(const Pair& pair, double h, const Speed& speed, double reach,
                                       PredictedStates& states) {
  const auto state = [&](BodyId id, double time) {
    if (can_move(context_->bodies, id)) return states.state_at(id, time);
    return id == kWorld ? hydro::BodyState{} : context_->world.state(id);
  };
  const auto time = unseen_contact(context_->world,
                                   {.pair = pair,
                                    .h = h,
                                    .speed = speed.linear,
                                    .turning = speed.angular,
                                    .reach = reach,
                                    .slow = slow_,
                                    .state = state},
                                   queries_);
  const bool met = std::binary_search(touching_.begin(), touching_.end(), pair);
  if (met && time == 0.0) return std::nullopt;  // their contact stops them
  return time;
}

std::optional<double> Impacts::onset(const Pair& pair, double time) const {
  const bool met = std::binary_search(touching_.begin(), touching_.end(), pair);
  const double past = kPastOnset * begun_;
  std::optional<double> found;
  for (int i = 0; i < kMostOnsetQueries; ++i) {
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
    const bool settled = found && *earliest > *found - past;
    found = earliest;
    if (settled) return found;
    time = *found + past;
  }
  return found;
}

}  // namespace engine
