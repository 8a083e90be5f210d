#include "engine/cluster_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/error_control.h"
#include "engine/free_motion.h"
#include "engine/free_step.h"

namespace engine {
namespace {

/// A body where contacts are looked for.
World::Placed placed(BodyId id, const Body& body, const Surroundings& around,
                     const hydro::BodyState& state) {
  return {.body = id,
          .state = state,
          .inertia = {.mass = contact_mass(body, body.motion),
                      .fall = contact_fall(body, body.motion),
                      .acceleration =
                          body.acceleration_W.value_or(-around.gravity * Eigen::Vector3d::UnitZ()),
                      .matrix_B = body.rigid_B + body.motion.added()}};
}

/// A member of an island whose added mass is `added_B` at the end of the step.
ConstrainedBody make_held(Body& body, BodyId id, const Surroundings& around, const Motion& middle,
                          const Matrix6d& added_B, double step, bool touching) {
  ConstrainedBody c{
      .body = &body, .id = id, .middle = make_middle(body, around, middle, added_B, Freedom{})};
  // An impact says nothing of the next kick.
  if (middle.constrained && !touching)
    c.expected =
        step * turned(middle.state.orientation.toRotationMatrix(), middle.kicks.expected(step / 2));
  return c;
}

/// The motion of a member at the end of the step.
Motion finish(const ConstrainedBody& c, const Surroundings& around, const Matrix6d& added_B,
              double step, bool touching) {
  const Motion& middle = *c.middle.motion;
  const Eigen::Matrix3d R_BW = middle.state.orientation.conjugate().toRotationMatrix();
  Motion after = middle;
  if (c.body->adds) set_added_mass(after, added_B, step);
  after.state = with_velocity(middle.state, c.middle.after + c.change, around.current());
  // As in a free step, the next kick does not follow from an implicit one.
  if (touching || c.implicit)
    after.kicks.clear();
  else
    after.kicks.add(turned(R_BW, c.change) / step, step, c.body->radius);
  after.constrained = true;
  after.energy = {};  // Joints and contacts pass energy on.
  check_state(*c.body, after.state);
  if (after.ledger) {
    const Vector6d reaction = turned(R_BW.transpose(), c.body->reaction_B);
    book_kick(*c.body, around, c.middle,
              {.change = c.change, .step = step, .implicit = c.implicit, .reaction = &reaction},
              after);
  }
  drift(*c.body, around, after, step / 2);
  check_state(*c.body, after.state);
  return after;
}

/// Work of the reactions on a member over the step [J].
double reaction_work(const ConstrainedBody& c, const Surroundings& around, double step) {
  const Eigen::Matrix3d R_WB = c.middle.motion->state.orientation.toRotationMatrix();
  const Vector6d mean = c.middle.after + c.change / 2;
  const Vector6d u = mean + stacked(around.current(), Eigen::Vector3d::Zero());
  return step * turned(R_WB, c.body->reaction_B).dot(u);
}

/// Largest turn of a body in a piece by its own inertia: its joints do not see that [rad].
constexpr double kLargestHeldTurn = 0.25;

/// Length of equal pieces of a step in which a body turns by no more than kLargestHeldTurn.
double turn_length(const Body& body, const Surroundings& around, double step, double shortest) {
  const double rate = own_turning_rate(body, around, body.motion);
  const double longest = std::max(shortest, rate > 0 ? kLargestHeldTurn / rate : step);
  return step / std::max(1.0, std::ceil(step / longest));
}

/// A step in which loads throw a body through the surface is cut in pieces shorter than the
/// shortest by other rules by this.
constexpr double kLeapParts = 16;

/// Of a step, what its pieces may miss of it.
constexpr double kMissedPart = 1e-12;

/// As kMostPasses: a pass of an island solves its constraints, often many times.
constexpr int kMostIslandPasses = 2;

}  // namespace

void step_alone(const Stepping& stepping, Body& body, double time, double step, double whole) {
  if (body.motion.constrained) body.motion.kicks.clear();
  body.motion.constrained = false;
  free_step(body, stepping.around, time, step, kShortestHalf * whole, stepping.tolerance);
  body.reaction_B.setZero();
  body.acceleration_W.reset();
}

ClusterStep::ClusterStep(const Stepping& stepping, const Cluster& cluster,
                         std::vector<EnergyGuard*> guards, const std::vector<Pair>& met,
                         double step)
    : stepping_(stepping),
      cluster_(cluster),
      guards_(std::move(guards)),
      step_(step),
      shortest_(step / kMostPieces),
      impacts_(stepping.world, stepping.bodies, stepping.around, cluster, met, step),
      members_(cluster.bodies.size()) {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    members_[i].id = cluster.bodies[i];
    members_[i].body = &stepping.bodies[static_cast<std::size_t>(members_[i].id)];
  }
}

void ClusterStep::Member::begin() {
  held.before = body->motion;
  reaction_before_B = body->reaction_B;
  acceleration_before_W = body->acceleration_W;
}

void ClusterStep::Member::go_back() const {
  body->motion = held.before;
  body->reaction_B = reaction_before_B;
  body->acceleration_W = acceleration_before_W;
}

ClusterStep::Member& ClusterStep::member(BodyId id) {
  const auto place = std::lower_bound(cluster_.bodies.begin(), cluster_.bodies.end(), id);
  return members_[static_cast<std::size_t>(place - cluster_.bodies.begin())];
}

void ClusterStep::advance(double time) {
  if (stepping_.tolerance > 0)
    advance_within_tolerance(time);
  else
    advance_in_pieces(time, step_, EnergyGuard::kMostHalvings);
}

void ClusterStep::advance_within_tolerance(double time) {
  double done = 0;
  double piece = step_;
  while (true) {
    piece = fit_piece(std::min(piece, step_ - done));
    const double error = islands_.empty() ? 0 : try_piece(time + done, piece);
    if (error <= 1 || piece <= shortest_) {
      for (const double start : {done, done + piece / 2})
        advance_in_pieces(time + start, piece / 2, EnergyGuard::kMostHalvings);
      done += piece;
      if (step_ - done <= kMissedPart * step_) return;
    }
    piece = std::max(length_for_error(piece, error), shortest_);
  }
}

double ClusterStep::try_piece(double time, double piece) {
  for (Member& m : members_) m.begin();
  const auto restart = [this] {
    for (Member& m : members_) m.go_back();
  };
  const auto run = [&](double start, double length) {
    advance_islands(start, length);
    advance_others(start, length);
  };
  std::vector<bool> held;  // A half may hold others.
  for (const Member& m : members_) held.push_back(m.island != kNone);
  run(time, piece);
  std::vector<Motion> whole;
  for (const Member& m : members_) whole.push_back(m.body->motion);
  restart();
  for (const double start : {time, time + piece / 2}) {
    meet_halfway(piece / 2);
    run(start, piece / 2);
  }
  double error = 0;
  for (std::size_t i = 0; i < members_.size(); ++i)
    if (held[i] && !members_[i].held.touching)
      error = std::max(error, estimated_error(*members_[i].body, whole[i], members_[i].body->motion,
                                              piece, stepping_.tolerance));
  restart();
  return error;
}

void ClusterStep::advance_in_pieces(double time, double length, int halvings) {
  double done = 0;
  while (true) {
    const double now = time + done;
    const double piece = begin_piece(length - done);
    if (advance_soundly(now, piece, halvings > 0 && piece / 2 >= shortest_)) {
      advance_others(now, piece);
      impacts_.accept(contacts_.pairs);
    } else {
      advance_in_pieces(now, piece / 2, halvings - 1);
      advance_in_pieces(now + piece / 2, piece / 2, halvings - 1);
    }
    done += piece;
    // An impact slows a body, a joint may make it spin: what is left is cut anew.
    if (length - done <= kMissedPart * step_) return;
  }
}

double ClusterStep::fit_piece(double rest) {
  // What the last piece held together is likely to be so still.
  const double piece = std::min(longest_piece(rest), impacts_.longest_piece());
  meet_halfway(piece);
  return shortened(piece, longest_piece(piece));
}

double ClusterStep::begin_piece(double rest) {
  const double piece = fit_piece(rest);
  return shortened(piece, impacts_.next(piece, contacts_.pairs).value_or(piece));
}

double ClusterStep::shortened(double piece, double longest) {
  if (longest >= piece) return piece;
  meet_halfway(longest);
  return longest;
}

void ClusterStep::meet_halfway(double piece) {
  std::vector<World::Placed> bodies;
  for (Member& m : members_) {
    m.middle = m.body->motion;
    drift(*m.body, stepping_.around, m.middle, piece / 2);
    check_state(*m.body, m.middle.state);
    m.held.touching = false;
    if (stepping_.collides)
      bodies.push_back(placed(m.id, *m.body, stepping_.around, m.middle.state));
  }
  if (stepping_.collides) contacts_ = stepping_.world.collide(bodies, cluster_.near, piece);
  for (const Pair& pair : contacts_.pairs)
    for (const BodyId id : {pair.first, pair.second})
      if (moves(stepping_.bodies, id)) member(id).held.touching = true;
  find_islands();
}

void ClusterStep::find_islands() {
  std::vector<Pair> pairs = cluster_.joints;
  pairs.insert(pairs.end(), contacts_.pairs.begin(), contacts_.pairs.end());
  islands_.clear();
  for (Member& m : members_) m.island = kNone;
  for (std::vector<BodyId>& bodies : groups(cluster_.bodies, pairs)) {
    const Member& first = member(bodies.front());
    if (bodies.size() == 1 && first.body->guide && !first.held.touching) continue;
    for (const BodyId id : bodies) member(id).island = islands_.size();
    islands_.push_back({.bodies = std::move(bodies), .contacts = {}});
  }
  for (const Contact& contact : contacts_.points) {
    const auto& [first, second] = contact.pair;
    islands_[member(moves(stepping_.bodies, first) ? first : second).island].contacts.push_back(
        contact);
  }
}

double ClusterStep::longest_piece(double rest) {
  double piece = rest;
  for (const Island& island : islands_)
    for (const BodyId id : island.bodies) {
      const Body& body = *member(id).body;
      piece = std::min({piece, piece_length(body, stepping_.around, body.motion, rest, shortest_),
                        turn_length(body, stepping_.around, rest, shortest_)});
    }
  return piece;
}

bool ClusterStep::advance_soundly(double time, double piece, bool may_halve) {
  const auto for_held = [&](const auto& f) {
    for (const Island& island : islands_)
      for (const BodyId id : island.bodies) f(member(id));
  };
  for_held([](Member& m) { m.begin(); });
  advance_islands(time, piece);
  const auto held = [this](std::size_t i) -> const HeldStep& {
    return member(static_cast<BodyId>(i)).held;
  };
  bool gained = false, leapt = false, followed = true;
  for (EnergyGuard* guard : guards_)
    gained = guard->gained(stepping_.bodies, held, piece) || gained;
  for_held([&](const Member& m) {
    const hydro::BodyState& before = m.held.before.state;
    followed = followed && can_be_followed(*m.body, stepping_.around, m.held.before, piece);
    leapt = leapt ||
            (m.body->wet && leaps(*m.body, stepping_.around, before, m.body->motion.state, piece));
  });
  if ((may_halve && gained && followed) || (leapt && piece / 2 >= shortest_ / kLeapParts)) {
    for_held([](Member& m) { m.go_back(); });
    return false;
  }
  for (EnergyGuard* guard : guards_) {
    guard->brake(stepping_.bodies, held);
    guard->accept();
  }
  return true;
}

void ClusterStep::advance_islands(double time, double piece) {
  call_all(stepping_.for_each, islands_.size(),
           [&](std::size_t i) { advance_island(islands_[i], time, piece); });
}

void ClusterStep::advance_island(const Island& island, double time, double piece) {
  std::vector<Member*> all;
  std::vector<Matrix6d> added;
  for (const BodyId id : island.bodies) {
    all.push_back(&member(id));
    added.push_back(expected_added_mass(*all.back()->body, all.back()->body->motion, piece));
  }
  std::vector<Motion> ends(all.size());
  std::vector<ConstrainedBody> last;
  bool near = false;
  for (int pass = 1;; ++pass) {
    std::vector<ConstrainedBody> constrained;
    for (std::size_t k = 0; k < all.size(); ++k) {
      constrained.push_back(make_held(*all[k]->body, island.bodies[k], stepping_.around,
                                      all[k]->middle, added[k], piece, all[k]->held.touching));
      if (!last.empty()) constrained[k].expected = last[k].change;
    }
    constrained_kick(stepping_.world, stepping_.around, stepping_.for_each, constrained,
                     island.contacts, time + piece / 2, piece);
    bool same = true, next_is_near = true;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Body& body = *all[k]->body;
      ends[k] = finish(constrained[k], stepping_.around, added[k], piece, all[k]->held.touching);
      all[k]->held.work = reaction_work(constrained[k], stepping_.around, piece);
      const Matrix6d found = added_mass(body, stepping_.around, ends[k].state, time + piece);
      if (same_added_mass(body, found, added[k])) continue;
      same = false;
      next_is_near = next_is_near && nearly_met(body, body.motion.added(), added[k], found);
      if (!near && pass == kMostIslandPasses)
        ends[k] = settled(body, stepping_.around, ends[k], found);
      added[k] = found;
    }
    if (same || near || pass == kMostIslandPasses) break;
    near = next_is_near;
    last = std::move(constrained);
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    Body& body = *all[k]->body;
    body.motion = ends[k];
    ++body.cost.constrained_steps;
    ++body.cost.substeps;
  }
}

void ClusterStep::advance_others(double time, double piece) {
  call_all(stepping_.for_each, members_.size(), [&](std::size_t i) {
    const Member& m = members_[i];
    if (m.island == kNone) step_alone(stepping_, *m.body, time, piece, step_);
  });
}

}  // namespace engine
