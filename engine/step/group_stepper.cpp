#include "engine/step/group_stepper.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "engine/base/constants.h"
#include "engine/base/prefetch.h"
#include "engine/motion/processing_correction.h"
#include "engine/step/step_controller.h"
#include "engine/step/substep_limit.h"

namespace engine {
namespace {

/// A body where contacts are looked for.
World::Placed placed(const SubstepBody& b) {
  const Motion& motion = b.moving->motion;
  return {.body = b.id,
          .state = b.halfway.state,
          .start = motion.state,
          .inertia = {.mass = contact_mass(b.body(), motion),
                      .fall = contact_fall(b.body(), motion),
                      .acceleration = motion.load_acceleration_W.value_or(
                          -b.body().environment.gravity * Eigen::Vector3d::UnitZ())}};
}

constexpr std::size_t kInPart = 16;  // Single bodies.
const std::vector<EnergyLimiter*> kNoLimiters;

/// True if the motion has no history yet and is about to get one.
bool starts(const MovingBody& moving) {
  return moving.motion.accelerations.empty() && shows_trend(moving.body, moving.motion) &&
         (moving.body.reduced_joint || may_be_wet(moving.body, moving.motion.state));
}

template <class Range, class T>
void append(const Range& more, std::vector<T>& all) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

PastContacts joined(const std::vector<PastContacts>& groups) {
  PastContacts all;
  for (const PastContacts& group : groups) {
    append(group.touching, all.touching);
    append(group.forces, all.forces);
  }
  std::ranges::sort(all.touching);
  std::ranges::stable_sort(all.forces, {}, &ContactForce::pair);
  return all;
}

GroupStepper::GroupStepper(const StepContext& context, Group group,
                           std::vector<EnergyLimiter*> limiters,
                           const std::vector<EnergyLimiter*>& own, const PastContacts& past,
                           double step)
    : context_(context),
      group_(std::move(group)),
      own_(own),
      is_alone_(group_.bodies.size() == 1 && group_.joints.empty() && group_.near.empty()),
      whole_step_(step),
      step_(step),
      shortest_((is_alone_ ? kShortestPart : kShortestConstrainedPart) * step),
      impacts_(context_, group_, past.touching, step),
      members_(group_.bodies.size()) {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    members_[i].id = group_.bodies[i];
    members_[i].moving = &context_.bodies[group_.bodies[i]];
    if (is_alone_) members_[i].island = 0;
  }
  for (EnergyLimiter* limiter : limiters) {
    judged_.push_back({.limiter = limiter, .members = {}});
    for (const BodyId id : limiter->group()) judged_.back().members.push_back(&member(id));
  }
  if (is_alone_)
    islands_.push_back({.bodies = {&members_.front()}, .contacts = {}, .constrained = false});
  else
    for (const Pair& pair : group_.near) append(forces_of(pair, past.forces), forces_);
}

GroupStepper::GroupStepper(const StepContext& context, const SingleBody& body, double step)
    : GroupStepper(context, {.bodies = {body.id}, .joints = {}, .near = {}}, {}, kNoLimiters, {},
                   step) {}

void GroupStepper::rebind(const SingleBody& body) {
  group_.bodies.front() = body.id;
  Member& m = members_.front();
  m.id = body.id;
  m.moving = &context_.bodies[body.id];
  judged_.resize(body.limiter ? 1 : 0);
  for (Judged& judged : judged_) {
    judged.limiter = body.limiter;
    judged.members.assign(1, &m);
  }
}

GroupStepper::Member& GroupStepper::member(BodyId id) {
  const auto place = std::lower_bound(group_.bodies.begin(), group_.bodies.end(), id);
  assert(place != group_.bodies.end() && *place == id);
  return members_[place - group_.bodies.begin()];
}

void GroupStepper::advance(double time, double length) {
  if (is_alone_) {
    MovingBody& moving = *members_.front().moving;
    ++moving.counts.free;
    if (moving.motion.constrained) moving.motion.accelerations.clear();
    moving.motion.constrained = false;
    step_ = length;
  }
  if (context_.tolerance > 0)
    advance_within_tolerance(time, length);
  else
    advance_in_substeps(time, length, false);
  context_.rig.accept(record_);
  record_ = {};
}

std::optional<std::vector<Group>> GroupStepper::split_by_contact(double time, double length) {
  if (is_part_ || members_.size() == 1) return std::nullopt;
  std::optional<std::vector<Pair>> connections = impacts_.meetings(length);
  if (!connections) return std::nullopt;
  find_contacts(time, length);
  append(group_.joints, *connections);
  append(contacts_.pairs, *connections);
  std::vector<Group> parts =
      make_groups(context_.bodies, group_.bodies, *connections, group_.joints, group_.near);
  if (parts.size() == 1 && parts[0].bodies.size() == members_.size()) return std::nullopt;
  return parts;
}

std::vector<EnergyLimiter*> GroupStepper::limiters_of(const Group& part) const {
  const auto first = [](const Judged& judged) { return judged.limiter->group().front(); };
  std::vector<EnergyLimiter*> limiters;
  for (const BodyId id : part.bodies) {
    const auto judged = std::ranges::lower_bound(judged_, id, {}, first);
    if (judged != judged_.end() && first(*judged) == id) limiters.push_back(judged->limiter);
  }
  return limiters;
}

void GroupStepper::advance_parts(const std::vector<Group>& parts, double time, double length) {
  std::vector<BodyId> grouped;
  for (const Group& part : parts) append(part.bodies, grouped);
  std::ranges::sort(grouped);
  std::vector<SingleBody> others;
  for (const Member& m : members_) {
    if (std::ranges::binary_search(grouped, m.id)) continue;
    m.moving->motion.longest_after_impact = std::numeric_limits<double>::infinity();
    others.push_back({m.id, own_[m.id]});
  }
  const SingleBodies single(context_, std::move(others), whole_step_);
  const PastContacts past = contacts();
  std::vector<std::unique_ptr<GroupStepper>> steppers;
  for (const Group& part : parts) {
    steppers.push_back(
        std::make_unique<GroupStepper>(context_, part, limiters_of(part), own_, past, whole_step_));
    steppers.back()->is_part_ = true;
  }
  parallel_for_rethrow(context_.parallel_for, steppers.size() + single.parts(), [&](std::size_t i) {
    if (i < steppers.size()) return steppers[i]->advance_in_substeps(time, length, false);
    single.advance(i - steppers.size(), time, length);
  });
  std::vector<PastContacts> ends;
  for (const auto& stepper : steppers) {
    ends.push_back(stepper->contacts());
    append(stepper->record_.rows, record_.rows);
    append(stepper->record_.reactions, record_.reactions);
    append(stepper->overlaps_, overlaps_);
  }
  PastContacts end = joined(ends);
  impacts_.set_touching(std::move(end.touching));
  forces_ = std::move(end.forces);
}

void GroupStepper::advance_in_substeps(double time, double length, bool halves) {
  if (!halves) {
    const std::optional<std::vector<Group>> parts = split_by_contact(time, length);
    if (parts) return advance_parts(*parts, time, length);
  }
  const bool starting = is_alone_ && !halves && starts(*members_.front().moving);
  double done = 0;
  for (int i = 0;; ++i) {
    const double h =
        next_length(time + done, length - done, starting && i < AccelerationHistory::kTrend);
    take_substeps(time + done, h);
    if (must_halve(h, halves)) {
      advance_in_substeps(time + done, h / 2, true);
      advance_in_substeps(time + done + h / 2, h / 2, true);
    } else {
      accept(time + done, h);
    }
    done += h;
    if (length - done <= kRoundOffPart * step_) return;
  }
}

void GroupStepper::advance_within_tolerance(double time, double length) {
  double done = 0;
  double h = length;
  while (true) {
    h = fitting_length(time + done, std::min(h, length - done));
    const Snapshot before = snapshot();
    take_substeps(time + done, h);
    std::vector<std::pair<const Member*, Motion>> whole;
    for (const Member& m : members_)
      if (m.island) whole.emplace_back(&m, m.end);
    for (const double start : {done, done + h / 2}) advance_in_substeps(time + start, h / 2, false);
    double error = 0;
    for (const auto& [m, end] : whole)
      if (!m->touching)
        error = std::max(error,
                         estimated_error(m->body(), end, m->moving->motion, h, context_.tolerance));
    if (error <= 1 || h <= shortest_)
      done += h;
    else
      restore(before);
    if (length - done <= kRoundOffPart * step_) return;
    h = std::max(length_for_error(h, error), shortest_);
  }
}

void GroupStepper::take_substeps(double time, double h) {
  if (islands_.size() == 1) return take_substep(context_, islands_.front(), time, h);
  parallel_for_rethrow(context_.parallel_for, islands_.size(),
                       [&](std::size_t i) { take_substep(context_, islands_[i], time, h); });
}

bool GroupStepper::must_halve(double h, bool halves) {
  bool gained = false, followed = true, unresolved = false;
  for (const Judged& judged : judged_) {
    if (!member(judged.members.front()->id).island) continue;
    gained = judged.limiter->judge(judged.members, h, halves && is_alone_) || gained;
  }
  gained = gained && h / 2 >= shortest_;
  for (const Member& m : members_) {
    if (!m.island) continue;
    const Motion& before = m.moving->motion;
    unresolved = unresolved || (!m.touching && added_mass_jumps(m.body(), before, m.end));
    if (!(gained || m.needs_energy_check)) continue;
    followed = followed && can_be_followed(m.body(), before, h);
    if (!m.needs_energy_check || !m.body().wet) continue;
    unresolved = unresolved || overshoots_surface(m.body(), before.state, m.end.state, h);
  }
  return (unresolved && h / 2 >= shortest_) || (gained && followed);
}

void GroupStepper::accept(double time, double h) {
  found_.reset();
  for (const Judged& judged : judged_)
    if (member(judged.members.front()->id).island) judged.limiter->clamp(judged.members);
  for (Member& m : members_)
    if (m.island) m.moving->motion = m.end;
  for (const Island& island : islands_) Rig::add(island, h, record_);
  if (is_alone_) return;
  add_overlaps(contacts_.points, time + h / 2, overlaps_);
  keep_forces();
  std::vector<SingleBody> others;
  for (const Member& m : members_)
    if (!m.island) others.push_back({m.id, own_[m.id]});
  const SingleBodies single(context_, std::move(others), whole_step_);
  parallel_for_rethrow(context_.parallel_for, single.parts(),
                       [&](std::size_t i) { single.advance(i, time, h); });
  impacts_.accept(contacts_.pairs);
}

GroupStepper::Snapshot GroupStepper::snapshot() const {
  Snapshot snapshot{.motions = {},
                    .ranges = {},
                    .impacts = impacts_,
                    .forces = forces_,
                    .rows = record_.rows.size(),
                    .reactions = record_.reactions.size(),
                    .overlaps = overlaps_.size()};
  for (const Member& m : members_) snapshot.motions.push_back(m.moving->motion);
  for (const Judged& judged : judged_) snapshot.ranges.push_back(judged.limiter->range());
  return snapshot;
}

void GroupStepper::restore(const Snapshot& snapshot) {
  found_.reset();
  for (std::size_t i = 0; i < members_.size(); ++i)
    members_[i].moving->motion = snapshot.motions[i];
  for (std::size_t i = 0; i < judged_.size(); ++i) judged_[i].limiter->restore(snapshot.ranges[i]);
  impacts_ = snapshot.impacts;
  forces_ = snapshot.forces;
  record_.rows.resize(snapshot.rows);
  record_.reactions.resize(snapshot.reactions);
  overlaps_.resize(snapshot.overlaps);
}

double GroupStepper::next_length(double time, double rest, bool starting) {
  const double h = fitting_length(time, rest);
  if (is_alone_) return starting ? std::min(h, kStartingPart * step_) : h;
  return shortened(time, h, impacts_.next(h, contacts_.pairs).value_or(h));
}

double GroupStepper::fitting_length(double time, double rest) {
  if (is_alone_) return longest_substep(rest);
  // The islands of the last substep are likely to be those of the next one.
  const double h = std::min(longest_substep(rest), impacts_.longest_substep());
  find_contacts(time, h);
  return shortened(time, h, longest_substep(h));
}

double GroupStepper::shortened(double time, double h, double longest) {
  if (longest >= h) return h;
  find_contacts(time, longest);
  return longest;
}

double GroupStepper::longest_substep(double rest) const {
  double h = rest;
  for (const Island& island : islands_)
    for (const SubstepBody* b : island.bodies)
      h = std::min(h, substep_limit(b->body(), b->moving->motion, rest, step_, island.constrained));
  return h;
}

void GroupStepper::find_contacts(double time, double h) {
  if (found_ == std::pair(time, h)) return;
  context_.check_stop();
  found_ = {time, h};
  std::vector<World::Placed> bodies;
  for (Member& m : members_) {
    drift_halfway(m, time, h);
    m.touching = false;
    if (context_.collides) bodies.push_back(placed(m));
  }
  if (context_.collides) {
    contacts_ = context_.world.collide(bodies, group_.near, h);
    recall(forces_, halfway_states(), contacts_.points);
  }
  for (const Pair& pair : contacts_.pairs)
    for (const BodyId id : {pair.first, pair.second})
      if (can_move(context_.bodies, id)) member(id).touching = true;
  find_islands();
}

StateOf GroupStepper::halfway_states() {
  return [this](BodyId id) {
    return can_move(context_.bodies, id) ? member(id).halfway.state
                                         : context_.bodies[id].motion.state;
  };
}

void GroupStepper::keep_forces() {
  std::vector<Contact> contacts;
  for (const Island& island : islands_) append(island.contacts, contacts);
  std::ranges::stable_sort(contacts, {}, &Contact::pair);
  forces_ = remembered(contacts, halfway_states());
}

void GroupStepper::find_islands() {
  std::vector<Pair> pairs = group_.joints;
  append(contacts_.pairs, pairs);
  islands_.clear();
  for (Member& m : members_) m.island.reset();
  for (const std::vector<BodyId>& connected : connected_components(group_.bodies, pairs)) {
    const Member& first = member(connected.front());
    if (connected.size() == 1 && first.body().reduced_joint && !first.touching) continue;
    Island island{.constrained = false};
    for (const BodyId id : connected) {
      Member& m = member(id);
      m.island = islands_.size();
      island.bodies.push_back(&m);
      const bool jointed = m.body().jointed && !m.body().reduced_joint;
      island.constrained = island.constrained || m.touching || jointed || m.body().driven_by_rows;
    }
    islands_.push_back(std::move(island));
  }
  for (const Contact& contact : contacts_.points) {
    const auto& [first, second] = contact.pair;
    const BodyId movable = can_move(context_.bodies, first) ? first : second;
    islands_[*member(movable).island].contacts.push_back(contact);
  }
}

std::size_t SingleBodies::parts() const { return (bodies_.size() + kInPart - 1) / kInPart; }

void SingleBodies::advance(std::size_t part, double time, double length) const {
  const std::size_t first = part * kInPart;
  const std::size_t last = std::min(first + kInPart, bodies_.size());
  GroupStepper stepper(context_, bodies_[first], step_);
  for (std::size_t i = first; i < last; ++i) {
    if (i + 2 < last) prefetch(context_.bodies[bodies_[i + 2].id]);
    if (i + 1 < last) prefetch(*context_.bodies[bodies_[i + 1].id].body.spec);
    if (i + 1 < last && bodies_[i + 1].limiter) prefetch(*bodies_[i + 1].limiter);
    stepper.rebind(bodies_[i]);
    stepper.advance(time, length);
  }
}

}  // namespace engine
