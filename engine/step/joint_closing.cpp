#include "engine/step/joint_closing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "engine/base/constants.h"
#include "engine/constraints/constraint_solver.h"
#include "engine/constraints/joint_rows.h"

namespace engine {
namespace {

/// A body, and the motion of it that is put on its joints.
struct Link {
  BodyId id;
  MovingBody* moving;
  Motion* motion;

  const Body& body() const { return moving->body; }
  Vector6d u() const { return velocity(motion->state, Eigen::Vector3d::Zero()); }
};

/// Bodies with all their joints.
class Linkage {
 public:
  /// @param links   Ascending.
  Linkage(const StepContext& context, std::vector<Link> links) : links_(std::move(links)) {
    std::vector<BodyId> ids;
    for (const Link& link : links_) ids.push_back(link.id);
    joints_ = context.world.joints_of(ids);
  }

  const std::vector<JointFrames>& joints() const { return joints_; }

  /// (E38) until the error is below kClosedJoint, or no step leads nearer.
  void close() {
    double before = error(states());
    for (int i = 0; i < kMostClosings && before > kClosedJoint; ++i) {
      const double after = try_closing(before);
      if (!(after < before)) return;
      before = after;
    }
  }

  struct Impulses {
    std::vector<ConstraintBlock> blocks;
    std::vector<Eigen::Vector3d> impulses;
  };
  /// (E39) unless the joints move by less than `least` of the speeds of their bodies.
  std::optional<Impulses> stop(double least) {
    std::vector<ConstraintBlock> blocks = this->blocks();
    for (ConstraintBlock& block : blocks) block.target.setZero();
    if (!moves(blocks, least)) return std::nullopt;
    std::vector<ConstrainedBody> bodies = bodies_at_rest();
    double energy = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const Vector6d u = bodies[k].velocity = links_[k].u();
      energy += u.dot(bodies[k].inertia * u);
    }
    ConstraintSolution found = solve(bodies, blocks, std::sqrt(energy));
    for (std::size_t k = 0; k < bodies.size(); ++k)
      change(links_[k], [&](Motion& motion) {
        motion.state = with_velocity(motion.state, found.velocities[k], Eigen::Vector3d::Zero());
      });
    return Impulses{.blocks = std::move(blocks), .impulses = std::move(found.impulses)};
  }

  const Link& link(BodyId id) const { return *find(id); }

 private:
  const Link* find(BodyId id) const {
    const auto found = std::ranges::lower_bound(links_, id, {}, &Link::id);
    return found == links_.end() || found->id != id ? nullptr : &*found;
  }

  /// States of all links, in their order.
  std::vector<hydro::BodyState> states() const {
    std::vector<hydro::BodyState> states;
    for (const Link& link : links_) states.push_back(link.motion->state);
    return states;
  }

  /// State of a link, or of a body that does not move.
  hydro::BodyState state(BodyId id, const std::vector<hydro::BodyState>& states) const {
    const Link* link = find(id);
    return link ? states[static_cast<std::size_t>(link - links_.data())] : hydro::BodyState{};
  }

  /// The radius of the smaller of a joint's bodies.
  double reach(const JointFrames& joint) const {
    double least = std::numeric_limits<double>::infinity();
    for (const BodyId id : joint.bodies)
      if (const Link* link = find(id)) least = std::min(least, link->body().radius);
    return least;
  }

  /// Root of the sum of the squares of all separations, over their reach, and turns. Short steps of
  /// Newton's method make it less.
  double error(const std::vector<hydro::BodyState>& states) const {
    double sum = 0;
    for (const JointFrames& joint : joints_) {
      const JointGap gap =
          gap_of(joint, state(joint.bodies[0], states), state(joint.bodies[1], states));
      sum += std::pow(gap.separation / reach(joint), 2) + std::pow(gap.turn, 2);
    }
    return std::sqrt(sum);
  }

  std::vector<ConstraintBlock> blocks() const {
    const std::vector<hydro::BodyState> states = this->states();
    std::vector<ConstraintBlock> blocks;
    for (const JointFrames& joint : joints_)
      add_joint_blocks(joint, state(joint.bodies[0], states), state(joint.bodies[1], states),
                       blocks);
    return blocks;
  }

  /// True if J u of a row exceeds a part of what its bodies could make of it with any direction.
  bool moves(const std::vector<ConstraintBlock>& blocks, double fraction) const {
    return std::ranges::any_of(blocks, [&](const ConstraintBlock& block) {
      Eigen::Vector3d rate = Eigen::Vector3d::Zero(), largest = Eigen::Vector3d::Zero();
      for (std::size_t side = 0; side < 2; ++side) {
        const Link* link = find(block.bodies[side]);
        if (!link) continue;
        rate += block.J[side] * link->u();
        largest += block.J[side].cwiseAbs() * link->u().cwiseAbs();
      }
      return (rate.cwiseAbs().array() > fraction * largest.array()).any();
    });
  }

  std::vector<ConstrainedBody> bodies_at_rest() const {
    std::vector<ConstrainedBody> bodies;
    for (const Link& link : links_) {
      const Matrix6d S = inertia_W(link.body(), *link.motion);
      bodies.push_back({.body = link.id,
                        .inertia = S,
                        .mobility = mobility_matrix(S, link.body().spec->locked)});
    }
    return bodies;
  }

  ConstraintSolution solve(const std::vector<ConstrainedBody>& bodies,
                           const std::vector<ConstraintBlock>& blocks, double size) {
    ConstraintSolution found = solve_constraints(bodies, blocks, {}, size);
    for (const Link& link : links_) link.moving->counts.iterations += found.sweeps;
    return found;
  }

  /// A step of Newton's method for (E38), or the largest of its halves that leads nearer; else
  /// nothing moves. @return the error after it
  double try_closing(double before) {
    double lightest = std::numeric_limits<double>::infinity();
    for (const Link& link : links_)
      lightest = std::min(lightest, link.body().radius * std::sqrt(link.body().spec->mass));
    const std::vector<Vector6d> step =
        solve(bodies_at_rest(), blocks(), before * lightest).velocities;
    double turn = 0;
    for (const Vector6d& d : step) turn = std::max(turn, d.tail<3>().norm());
    double fraction = turn > kLargestClosingTurn ? kLargestClosingTurn / turn : 1;
    std::vector<hydro::BodyState> ends(links_.size());
    for (int i = 0; i <= kMostClosings; ++i, fraction /= 2) {
      for (std::size_t k = 0; k < links_.size(); ++k)
        ends[k] = displaced(links_[k].body(), links_[k].motion->state, fraction * step[k]);
      const double after = error(ends);
      if (!(after < before)) continue;
      for (std::size_t k = 0; k < links_.size(); ++k) displace(links_[k], ends[k]);
      return after;
    }
    return before;
  }

  /// Moves a body to the pose of a state. It keeps its kinetic energy.
  static void displace(const Link& link, const hydro::BodyState& end) {
    const Body& body = link.body();
    change(link, [&](Motion& motion) {
      hydro::BodyState& state = motion.state;
      const Eigen::Quaterniond start = state.orientation;
      state = end;
      const Eigen::Quaterniond turn = state.orientation * start.conjugate();
      if (!body.locked) state.angular_velocity = turn * state.angular_velocity;
      if (!motion.added_B) return;
      if (!body.locked)
        state.linear_velocity = motion.flow + turn * (state.linear_velocity - motion.flow);
      motion.added_B = after_turn(body, *motion.added_B, motion.carried_water.get(),
                                  start.conjugate() * state.orientation);
    });
  }

  template <class Apply>
  static void change(const Link& link, const Apply& apply) {
    Motion& motion = *link.motion;
    if (!motion.work) return apply(motion);
    const Motion before = motion;
    apply(motion);
    record_joints(link.body(), before, motion);
  }

  std::vector<Link> links_;
  std::vector<JointFrames> joints_;
};

/// The ends of an island.
Linkage ends_of(const StepContext& context, const Island& island) {
  std::vector<Link> links;
  for (SubstepBody* b : island.bodies) links.push_back({b->id, b->moving, &b->end});
  return {context, std::move(links)};
}

}  // namespace

void begin_on_joints(const StepContext& context, const std::vector<BodyId>& bodies) {
  std::vector<Link> links;
  for (const BodyId id : bodies)
    links.push_back({id, &context.bodies[id], &context.bodies[id].motion});
  Linkage linkage(context, std::move(links));
  linkage.close();
  linkage.stop(kStoppedJoint);
}

void close_joints(const StepContext& context, Island& island) { ends_of(context, island).close(); }

void stop_joints(const StepContext& context, Island& island, double h) {
  Linkage linkage = ends_of(context, island);
  const auto stopped = linkage.stop(kStoppedJoint);
  if (!stopped) return;
  std::size_t next = 0;
  for (std::size_t i = 0; i < linkage.joints().size(); ++i) {
    const JointFrames& joint = linkage.joints()[i];
    const Vector6d load = joint_impulse(joint, stopped->blocks, stopped->impulses, next) / h;
    JointReaction& reaction = island.reactions[i];
    const Eigen::Vector3d arm =
        linkage.link(joint.seen_by()).motion->state.position - reaction.about_W;
    reaction.force_W += load.head<3>();
    reaction.moment_W += load.tail<3>() + arm.cross(load.head<3>());
  }
}

}  // namespace engine
