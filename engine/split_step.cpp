#include "engine/split_step.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "engine/constrained_step.h"
#include "engine/free_motion.h"
#include "engine/free_step.h"

namespace engine {
namespace {

/// A member of an island whose added mass is `added_B` at the end of the step.
ConstrainedBody make_member(Body& body, BodyId id, const Surroundings& around, const Motion& middle,
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
  const Motion& middle = c.middle.motion;
  const Eigen::Matrix3d R_BW = middle.state.orientation.conjugate().toRotationMatrix();
  Motion after = with_added_mass(middle, added_B, middle.added_B, step);
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
  after = drift(*c.body, around, after, step / 2);
  check_state(*c.body, after.state);
  return after;
}

/// Work of the reactions on a member over the step [J].
double reaction_work(const ConstrainedBody& c, const Surroundings& around, double step) {
  const Eigen::Matrix3d R_WB = c.middle.motion.state.orientation.toRotationMatrix();
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

SplitStep::SplitStep(World& world, std::vector<Body>& bodies, const Surroundings& around,
                     ForEach for_each, bool collides, double tolerance)
    : world_(world),
      bodies_(bodies),
      around_(around),
      for_each_(std::move(for_each)),
      collides_(collides),
      jointed_(std::any_of(bodies.begin(), bodies.end(),
                           [](const Body& b) { return b.jointed && !b.guide; })),
      tolerance_(tolerance),
      middle_(bodies.size()),
      before_(bodies.size()),
      touching_(bodies.size()),
      work_(bodies.size()),
      guard_(world.islands(), bodies, around) {}

void SplitStep::advance(double time, double step) {
  shortest_ = step / kMostPieces;
  if (any_constraint())
    advance_in_pieces(time, step, EnergyGuard::kMostHalvings);
  else
    advance_free({}, time, step);
}

void SplitStep::advance_in_pieces(double time, double step, int halvings) {
  double done = 0;
  std::vector<std::vector<BodyId>> islands = find_islands(step);
  double piece = longest_piece(islands, step);
  if (piece < step) islands = find_islands(piece);
  while (true) {
    const double now = time + done;
    if (advance_soundly(islands, now, piece, halvings > 0 && piece / 2 >= shortest_)) {
      advance_free(islands, now, piece);
    } else {
      advance_in_pieces(now, piece / 2, halvings - 1);
      advance_in_pieces(now + piece / 2, piece / 2, halvings - 1);
    }
    const double rest = step - done - piece;
    if (rest <= kMissedPart * step) return;
    done += piece;
    // An impact slows a body, a joint may make it spin: what is left is cut anew.
    piece = longest_piece(islands, rest);
    islands = find_islands(piece);
  }
}

std::vector<std::vector<BodyId>> SplitStep::find_islands(double step) {
  drift_to_middle(step);
  collide(step);
  return held_islands();
}

bool SplitStep::advance_soundly(const std::vector<std::vector<BodyId>>& islands, double time,
                                double step, bool may_halve) {
  const auto for_members = [&](const auto& f) {
    for (const std::vector<BodyId>& island : islands)
      for (const BodyId id : island)
        f(bodies_[static_cast<std::size_t>(id)], before_[static_cast<std::size_t>(id)]);
  };
  for_members([](const Body& body, Before& before) {
    before = {body.motion, body.reaction_B, body.acceleration_W};
  });
  advance_constrained(islands, time, step);
  const auto motion_before = [this](std::size_t i) -> const Motion& { return before_[i].motion; };
  const bool gained = guard_.gained(bodies_, motion_before, touching_, work_, step);
  bool leapt = false, followed = true;
  for_members([&](const Body& body, const Before& before) {
    followed = followed && can_be_followed(body, around_, before.motion, step);
    leapt =
        leapt || (body.wet && leaps(body, around_, before.motion.state, body.motion.state, step));
  });
  if ((may_halve && gained && followed) || (leapt && step / 2 >= shortest_ / kLeapParts)) {
    for_members([](Body& body, const Before& before) {
      body.motion = before.motion;
      body.reaction_B = before.reaction_B;
      body.acceleration_W = before.acceleration_W;
    });
    return false;
  }
  guard_.brake(bodies_, motion_before);
  guard_.accept();
  return true;
}

void SplitStep::drift_to_middle(double step) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body& body = bodies_[i];
    if (!body.movable) continue;
    middle_[i] = drift(body, around_, body.motion, step / 2);
    check_state(body, middle_[i].state);
    const auto id = static_cast<BodyId>(i);
    world_.set_state(id, middle_[i].state);
    world_.set_contact_inertia(
        id, contact_mass(body, body.motion), contact_fall(body, body.motion),
        body.acceleration_W.value_or(-around_.gravity * Eigen::Vector3d::UnitZ()));
  }
}

void SplitStep::collide(double step) {
  if (!collides_) return;
  const auto start = std::chrono::steady_clock::now();
  world_.collide(step);
  collision_seconds_ +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<std::vector<BodyId>> SplitStep::held_islands() const {
  std::vector<std::vector<BodyId>> islands = world_.islands();
  const std::vector<bool> touching = world_.touching();
  std::erase_if(islands, [&](const std::vector<BodyId>& island) {
    const auto first = static_cast<std::size_t>(island.front());
    return island.size() == 1 && bodies_[first].guide && !touching[first];
  });
  return islands;
}

double SplitStep::longest_piece(const std::vector<std::vector<BodyId>>& islands,
                                double step) const {
  double piece = step;
  for (const std::vector<BodyId>& island : islands)
    for (const BodyId id : island) {
      const Body& body = bodies_[static_cast<std::size_t>(id)];
      piece = std::min({piece, piece_length(body, around_, body.motion, step, shortest_),
                        turn_length(body, around_, step, shortest_)});
    }
  return piece;
}

void SplitStep::advance_constrained(const std::vector<std::vector<BodyId>>& islands, double time,
                                    double step) {
  touching_ = world_.touching();
  call_all(for_each_, islands.size(),
           [&](std::size_t i) { advance_island(islands[i], time, step); });
}

void SplitStep::advance_island(const std::vector<BodyId>& island, double time, double step) {
  const auto index = [&](std::size_t k) { return static_cast<std::size_t>(island[k]); };
  std::vector<Matrix6d> added;
  for (std::size_t k = 0; k < island.size(); ++k)
    added.push_back(expected_added_mass(bodies_[index(k)], bodies_[index(k)].motion, step));
  std::vector<Motion> ends(island.size());
  std::vector<ConstrainedBody> last;
  bool near = false;
  for (int pass = 1;; ++pass) {
    std::vector<ConstrainedBody> members;
    for (std::size_t k = 0; k < island.size(); ++k) {
      members.push_back(make_member(bodies_[index(k)], island[k], around_, middle_[index(k)],
                                    added[k], step, touching_[index(k)]));
      if (!last.empty()) members[k].expected = last[k].change;
    }
    constrained_kick(world_, around_, for_each_, members, time + step / 2, step);
    bool same = true, next_is_near = true;
    for (std::size_t k = 0; k < island.size(); ++k) {
      const Body& body = bodies_[index(k)];
      ends[k] = finish(members[k], around_, added[k], step, touching_[index(k)]);
      work_[index(k)] = reaction_work(members[k], around_, step);
      const Matrix6d found = added_mass(body, around_, ends[k].state, time + step);
      if (same_added_mass(body, found, added[k])) continue;
      same = false;
      next_is_near = next_is_near && nearly_met(body, body.motion.added_B, added[k], found);
      if (!near && pass == kMostIslandPasses) ends[k] = settled(body, around_, ends[k], found);
      added[k] = found;
    }
    if (same || near || pass == kMostIslandPasses) break;
    near = next_is_near;
    last = std::move(members);
  }
  for (std::size_t k = 0; k < island.size(); ++k) {
    Body& body = bodies_[index(k)];
    body.motion = ends[k];
    ++body.cost.constrained_steps;
    ++body.cost.substeps;
  }
}

void SplitStep::advance_free(const std::vector<std::vector<BodyId>>& islands, double time,
                             double step) {
  std::vector<bool> held(bodies_.size(), false);
  for (const std::vector<BodyId>& island : islands)
    for (const BodyId id : island) held[static_cast<std::size_t>(id)] = true;
  call_all(for_each_, bodies_.size(), [&](std::size_t i) {
    Body& body = bodies_[i];
    if (held[i] || !body.movable) return;
    if (body.motion.constrained) body.motion.kicks.clear();
    body.motion.constrained = false;
    body.motion = free_step(body, around_, body.motion, time, step, tolerance_);
    body.reaction_B.setZero();
    body.acceleration_W.reset();
  });
}

}  // namespace engine
