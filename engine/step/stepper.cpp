#include "engine/step/stepper.h"

#include <cassert>
#include <utility>

#include "engine/step/impact_boxes.h"
#include "engine/step/joint_closing.h"

namespace engine {

Stepper::Stepper(StepContext context, double step) : context_(std::move(context)), step_(step) {
  const std::vector<MovingBody>& bodies = context_.bodies;
  const auto is_reduced = [&](BodyId id) { return id != kWorld && bodies[id].body.reduced_joint; };
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].body.movable)
      movable_.push_back(static_cast<BodyId>(i));
    else if (bodies[i].motion.work || bodies[i].body.hollow)
      watched_.push_back({static_cast<BodyId>(i), nullptr});
  for (const Pair& pair : context_.world.joints())
    if (!is_reduced(pair.first) && !is_reduced(pair.second)) joints_.push_back(pair);
  const std::vector<Pair>& lines = context_.rig.couplings();
  joints_.insert(joints_.end(), lines.begin(), lines.end());
  limiter_of_.resize(bodies.size());
  std::vector<Pair> pairs = joints_;
  for (const BodyId id : movable_) pairs.emplace_back(kWorld, id);  // so that no body is left out
  for (std::vector<BodyId>& group : connected_components(movable_, pairs)) {
    for (const BodyId id : group) limiter_of_[id] = limiters_.size();
    limiters_.emplace_back(std::move(group), bodies);
  }
  own_limiters_.resize(bodies.size(), nullptr);
  for (EnergyLimiter& limiter : limiters_)
    if (limiter.group().size() == 1) own_limiters_[limiter.group().front()] = &limiter;
}

std::vector<Overlap> Stepper::advance(double time) {
  std::vector<Group> groups = find_groups(near_pairs());
  const SingleBodies single(context_, single_bodies(groups), step_);
  std::vector<PastContacts> ends(groups.size());
  std::vector<std::vector<Overlap>> found(groups.size());
  parallel_for_rethrow(context_.parallel_for, groups.size() + single.parts(), [&](std::size_t i) {
    if (i >= groups.size()) return single.advance(i - groups.size(), time, step_);
    if (!groups[i].joints.empty()) begin_on_joints(context_, groups[i].bodies);
    GroupStepper stepper(context_, groups[i], limiters_of(groups[i]), own_limiters_, contacts_,
                         step_);
    stepper.advance(time, step_);
    ends[i] = stepper.contacts();
    found[i] = stepper.overlaps();
  });
  contacts_ = joined(ends);
  std::vector<Overlap> overlaps;
  for (const std::vector<Overlap>& of_group : found)
    overlaps.insert(overlaps.end(), of_group.begin(), of_group.end());
  return overlaps;
}

std::vector<Pair> Stepper::near_pairs() {
  if (!context_.collides) return {};
  const World& world = context_.world;
  const std::vector<MovingBody>& bodies = context_.bodies;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    boxes.push_back(swept_box(world.shape_box(static_cast<BodyId>(i)), bodies[i].motion.state,
                              context_.gravity, step_));
  boxes.push_back(world.ground_box());
  return world.touchable(with_impacts(context_, step_, boxes, broad_phase_.find(boxes)));
}

std::vector<Group> Stepper::find_groups(const std::vector<Pair>& near) const {
  std::vector<Pair> connections = near;
  connections.insert(connections.end(), joints_.begin(), joints_.end());
  // A body on a reduced joint is in a group only where something is near.
  std::vector<Pair> joints = context_.world.joints();
  const std::vector<Pair>& lines = context_.rig.couplings();
  joints.insert(joints.end(), lines.begin(), lines.end());
  return make_groups(context_.bodies, movable_, connections, joints, near);
}

std::vector<EnergyLimiter*> Stepper::limiters_of(const Group& group) {
  std::vector<EnergyLimiter*> limiters;
  for (const BodyId id : group.bodies) {
    EnergyLimiter& limiter = limiters_[limiter_of_[id]];
    if (limiter.group().front() == id) limiters.push_back(&limiter);
  }
  return limiters;
}

std::vector<SingleBody> Stepper::single_bodies(const std::vector<Group>& groups) const {
  std::vector<bool> alone(context_.bodies.size(), true);
  for (const Group& group : groups)
    for (const BodyId id : group.bodies) alone[id] = false;
  std::vector<SingleBody> single = watched_;
  for (const BodyId id : movable_)
    if (alone[id]) single.push_back({id, own_limiters_[id]});
  return single;
}

StepperState Stepper::state() const {
  StepperState state{.contacts = contacts_, .ranges = {}};
  for (const EnergyLimiter& limiter : limiters_) state.ranges.push_back(limiter.range());
  return state;
}

void Stepper::restore(const StepperState& state) {
  assert(fits(state));
  contacts_ = state.contacts;
  for (std::size_t i = 0; i < limiters_.size(); ++i) limiters_[i].restore(state.ranges[i]);
}

void Stepper::forget(BodyId body) {
  if (context_.bodies[body].body.movable) limiters_[limiter_of_[body]].restore({});
}

}  // namespace engine
