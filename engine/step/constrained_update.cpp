#include "engine/step/constrained_update.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/base/constants.h"
#include "engine/base/state_checks.h"
#include "engine/base/stopwatch.h"
#include "engine/constraints/constraint_solver.h"
#include "engine/constraints/joint_rows.h"
#include "engine/constraints/restitution.h"

namespace engine {
namespace {

/// The terms of (E7) for one body, in W.
struct Pushed {
  Matrix6d S = Matrix6d::Identity();  ///< Effective inertia.
  Matrix6d mobility;                  ///< Its inverse in the velocities that locks leave.
  Vector6d load;                      ///< F, with the jump as a load.
  Vector6d before;                    ///< u⁻
  Vector6d jump;                      ///< Change of velocity by that of the added mass.
  bool implicit = false;

  Vector6d unconstrained(double h) const { return before + h * mobility * load; }
};

Pushed make_pushed(const SubstepBody& c, double time, double h, hydro::Pieces pieces) {
  const EffectiveLoad effective =
      effective_load(*c.moving, c.midpoint, c.predicted, time, h, pieces);
  const Vector6d jump = c.midpoint.after - c.midpoint.before;
  return {.S = effective.inertia,
          .mobility = mobility_matrix(effective.inertia, c.body().spec->locked),
          .load = effective.load + effective.inertia * jump / h,
          .before = velocity(c.halfway.state, Eigen::Vector3d::Zero()),
          .jump = jump,
          .implicit = effective.implicit};
}

/// The constraints of an island for one linearisation of its loads.
struct Problem {
  const StepContext& context;
  Island& island;
  const std::vector<Pushed>& bodies;
  double h;
};

/// Energy of the motion that the reactions act on, and of the one that loads add [J].
double motion_energy(const Problem& problem) {
  double sum = 0;
  for (const Pushed& b : problem.bodies) {
    const Vector6d push = problem.h * b.load;
    sum += b.before.dot(b.S * b.before) + push.dot(b.mobility * push);
  }
  return sum / 2;
}

/// The constraints of an island, beside its lines and drives.
struct Constraints {
  const std::vector<JointFrames>& joints;
  const std::vector<Contact>& contacts;
};

/// Index of a body in the island; none for one that does not move.
std::optional<std::size_t> place_in(const Island& island, BodyId id) {
  const auto found = std::ranges::lower_bound(island.bodies, id, {}, &SubstepBody::id);
  if (found == island.bodies.end() || (*found)->id != id) return std::nullopt;
  return static_cast<std::size_t>(found - island.bodies.begin());
}

/// The rows of joints, then of contacts, then of lines and drives.
std::vector<ConstraintBlock> blocks_of(const Problem& problem, const Constraints& constraints) {
  const Island& island = problem.island;
  const auto state_of = [&](BodyId id) {
    const auto place = place_in(island, id);
    return place ? island.bodies[*place]->halfway.state : hydro::BodyState{};
  };
  const auto velocity_before = [&](BodyId id) {
    const auto place = place_in(island, id);
    return place ? problem.bodies[*place].before : Vector6d::Zero();
  };
  const double h = problem.h;
  std::vector<ConstraintBlock> blocks;
  blocks.reserve(3 * constraints.joints.size() + constraints.contacts.size() + island.rows.size());
  for (const JointFrames& joint : constraints.joints)
    add_joint_blocks(joint, state_of(joint.bodies[0]), state_of(joint.bodies[1]), blocks);
  for (ConstraintBlock& block : blocks)
    block.target = -block.J[0] * velocity_before(block.bodies[0]) -
                   block.J[1] * velocity_before(block.bodies[1]);
  for (const Contact& contact : constraints.contacts)
    blocks.push_back(contact_block(contact, state_of(contact.pair.first).position,
                                   state_of(contact.pair.second).position, h));
  for (const ForceRow& row : island.rows)
    blocks.push_back(
        force_block(row, state_of(row.first).position, state_of(row.second).position, h));
  return blocks;
}

/// The reactions of joints, whose blocks come first.
std::vector<JointReaction> joint_reactions(const Problem& problem,
                                           const std::vector<JointFrames>& joints,
                                           const std::vector<ConstraintBlock>& blocks,
                                           const std::vector<Eigen::Vector3d>& impulses) {
  std::vector<JointReaction> reactions;
  std::size_t k = 0;
  for (const JointFrames& joint : joints) {
    const Vector6d load = joint_impulse(joint, blocks, impulses, k) / problem.h;
    const std::size_t body = *place_in(problem.island, joint.seen_by());
    reactions.push_back({.joint = joint.index,
                         .force_W = load.head<3>(),
                         .moment_W = load.tail<3>(),
                         .about_W = problem.island.bodies[body]->halfway.state.position});
  }
  return reactions;
}

/// An answer to the loads: the changes of velocity, and R.
using Answer = ImpactAnswer;

/// Forces of the rows of lines and drives, whose blocks come last, and their work.
void add_rows(const Problem& problem, const std::vector<ConstraintBlock>& blocks,
              const ConstraintSolution& found, Answer& answer) {
  const std::size_t rows = problem.island.rows.size();
  for (std::size_t k = blocks.size() - rows; k < blocks.size(); ++k) {
    const double impulse = found.impulses[k][0];
    answer.row_forces.push_back(impulse / problem.h);
    for (int side = 0; side < 2; ++side) {
      const auto place = place_in(problem.island, blocks[k].bodies[side]);
      if (!place) continue;
      const Pushed& body = problem.bodies[*place];
      const Vector6d mean = (body.before + body.jump + found.velocities[*place]) / 2;
      answer.row_work += impulse * blocks[k].J[side].row(0).dot(mean);
    }
  }
}

/// Impulses to start from: those of the forces that contacts and rows had last.
std::vector<Eigen::Vector3d> expected_impulses(const Problem& problem,
                                               const Constraints& constraints,
                                               const std::vector<ConstraintBlock>& blocks) {
  std::vector<Eigen::Vector3d> impulses(blocks.size(), Eigen::Vector3d::Zero());
  std::size_t k = blocks.size() - problem.island.rows.size() - constraints.contacts.size();
  for (const Contact& contact : constraints.contacts) {
    impulses[k] = problem.h * blocks[k].J[0].leftCols<3>() * contact.force_W;
    ++k;
  }
  for (const ForceRow& row : problem.island.rows) impulses[k++][0] = problem.h * row.force;
  return impulses;
}

/// Keeps the forces of contacts that were found.
void keep_forces(const std::vector<ConstraintBlock>& blocks,
                 const std::vector<Eigen::Vector3d>& impulses, const Problem& problem) {
  std::vector<Contact>& contacts = problem.island.contacts;
  std::size_t k = blocks.size() - problem.island.rows.size() - contacts.size();
  for (Contact& contact : contacts) {
    contact.force_W = blocks[k].J[0].leftCols<3>().transpose() * impulses[k] / problem.h;
    ++k;
  }
}

Answer solve(const Problem& problem, const Constraints& constraints) {
  const Island& island = problem.island;
  std::vector<ConstrainedBody> bodies;
  bodies.reserve(island.bodies.size());
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const Pushed& b = problem.bodies[i];
    bodies.push_back({island.bodies[i]->id, b.S, b.mobility, b.unconstrained(problem.h)});
  }
  const std::vector<ConstraintBlock> blocks = blocks_of(problem, constraints);
  problem.context.check_stop();
  const Stopwatch stopwatch(island.bodies.front()->moving->cache.constraint_seconds);
  const ConstraintSolution found =
      solve_constraints(bodies, blocks, expected_impulses(problem, constraints, blocks),
                        std::sqrt(2 * motion_energy(problem)));
  keep_forces(blocks, found.impulses, problem);
  Answer answer{.joints = joint_reactions(problem, constraints.joints, blocks, found.impulses),
                .solved = found.converged};
  answer.changes.reserve(bodies.size());
  answer.reactions.reserve(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Pushed& b = problem.bodies[i];
    const Vector6d change = found.velocities[i] - b.before;
    answer.changes.push_back(change - b.jump);
    answer.reactions.push_back(b.S * change / problem.h - b.load);
    island.bodies[i]->moving->counts.iterations += found.sweeps;
  }
  add_rows(problem, blocks, found, answer);
  return answer;
}

/// The answer without any forces of constraints.
Answer without_reactions(const Problem& problem, Answer answer) {
  for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
    const Pushed& b = problem.bodies[i];
    answer.changes[i] = b.unconstrained(problem.h) - b.before - b.jump;
    answer.reactions[i].setZero();
  }
  std::ranges::fill(answer.row_forces, 0);
  answer.row_work = 0;
  for (JointReaction& joint : answer.joints) joint.force_W = joint.moment_W = {0, 0, 0};
  return answer;
}

/// A bound of the energy that contacts may give as they push bodies apart [J].
double overlap_energy(const Problem& problem) {
  double weight = 0, deepest = 0;
  for (const SubstepBody* b : problem.island.bodies)
    weight += b->body().spec->mass * problem.context.gravity;
  for (const Contact& contact : problem.island.contacts)
    deepest = std::max(deepest, contact.point.depth);
  return weight * deepest;
}

/// Velocities of the bodies before the update, in W.
std::vector<Vector6d> velocities_before(const Problem& problem) {
  std::vector<Vector6d> before;
  before.reserve(problem.bodies.size());
  for (const Pushed& b : problem.bodies) before.push_back(b.before + b.jump);
  return before;
}

/// The answer, less what restitution would give of energy (E33).
Answer less_restitution(const Problem& problem, const std::vector<JointFrames>& joints,
                        Answer answer) {
  if (!restores(problem.island.contacts)) return answer;
  const std::vector<Vector6d> before = velocities_before(problem);
  if (!gains(answer, before, problem.h, 0)) return answer;
  const std::vector<Contact> contacts = without_restitution(problem.island.contacts);
  return without_gain(solve(problem, {joints, contacts}), answer, before, problem.h, 0);
}

/// The answer; of one that is not solved only what no more than overlaps give of energy.
Answer solve(const Problem& problem) {
  std::vector<BodyId> ids;
  for (const SubstepBody* b : problem.island.bodies) ids.push_back(b->id);
  const std::vector<JointFrames> joints = problem.context.world.joints_of(ids);
  Answer answer =
      less_restitution(problem, joints, solve(problem, {joints, problem.island.contacts}));
  if (answer.solved) return answer;
  const std::vector<Vector6d> before = velocities_before(problem);
  // A substep as long as kShortestContact may gain the whole amount; shorter ones share it.
  const double part = problem.h / std::max(problem.h, kShortestContact);
  const double most = part * (kUnsolvedWork * motion_energy(problem) + overlap_energy(problem));
  if (!gains(answer, before, problem.h, most)) return answer;
  return without_gain(without_reactions(problem, answer), answer, before, problem.h, most);
}

/// True if the changes agree with those that the loads were linearised about.
bool has_converged(const Problem& problem, const Answer& answer) {
  for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
    const Pushed& b = problem.bodies[i];
    if (!b.implicit) continue;
    const Vector6d& change = answer.changes[i];
    const Vector6d off = change - problem.island.bodies[i]->predicted;
    if (off.dot(b.S * off) > kNewtonTolerance * kNewtonTolerance * change.dot(b.S * change))
      return false;
  }
  return true;
}

/// Energy of what the changes miss of those that the loads were linearised about.
double missed(const Problem& problem, const Answer& answer) {
  double sum = 0;
  for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
    const Pushed& b = problem.bodies[i];
    if (!b.implicit) continue;
    const Vector6d off = answer.changes[i] - problem.island.bodies[i]->predicted;
    sum += off.dot(b.S * off);
  }
  return sum;
}

/// Makes the answer that of the island.
void keep(const Problem& problem, const Answer& answer) {
  Island& island = problem.island;
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
    SubstepBody& c = *island.bodies[k];
    const Pushed& b = problem.bodies[k];
    c.update = {.change = answer.changes[k], .implicit = b.implicit, .unsolved = !answer.solved};
    c.reaction_B = rotate(c.midpoint.R_WB.transpose(), answer.reactions[k]);
    c.load_acceleration_W = (b.mobility * b.load).head<3>();
  }
  for (std::size_t k = 0; k < island.rows.size(); ++k) island.rows[k].force = answer.row_forces[k];
  island.reactions = answer.joints;
}

/// The state that the loads alone lead a body to.
hydro::BodyState unconstrained_state(const SubstepBody& c, const Pushed& b, double h) {
  return with_velocity(c.halfway.state, b.unconstrained(h), Eigen::Vector3d::Zero());
}

/// Solves (E7) for loads that are linearised about the last answer, until both agree; where they
/// lead away from each other, the nearest answer counts.
/// @return true if they agree
bool linearise(const StepContext& context, Island& island, double time, double h,
               hydro::Pieces pieces) {
  std::vector<Pushed> pushed(island.bodies.size());
  const Problem problem{.context = context, .island = island, .bodies = pushed, .h = h};
  double least = std::numeric_limits<double>::infinity();
  // On fine pieces, half steps lead no nearer.
  const int most = pieces == hydro::Pieces::fine ? kFullNewtonSteps : kMostLinearisations;
  for (int i = 0; i < most; ++i) {
    parallel_for_rethrow(context.parallel_for, pushed.size(), [&](std::size_t k) {
      context.check_stop();
      pushed[k] = make_pushed(*island.bodies[k], time, h, pieces);
    });
    for (std::size_t k = 0; k < pushed.size(); ++k) {
      const hydro::BodyState state = unconstrained_state(*island.bodies[k], pushed[k], h);
      // Loads that lead beyond all bounds are a fault of the motion only where none led elsewhere.
      if (i == 0 && pieces == hydro::Pieces::coarse)
        check_state(*island.bodies[k]->moving, state);
      else if (state_fault(state))
        return false;
    }
    const Answer answer = solve(problem);
    const bool done = has_converged(problem, answer);
    const double off = missed(problem, answer);
    if (done || !(off >= least)) keep(problem, answer);
    if (done) return true;
    if (off > kLedAway * least) return false;
    least = std::min(least, off);
    for (std::size_t k = 0; k < pushed.size(); ++k) {
      // Where Newton's method alternates, the mean is nearer.
      Vector6d& predicted = island.bodies[k]->predicted;
      const Vector6d& change = answer.changes[k];
      predicted = i < kFullNewtonSteps ? change : Vector6d((predicted + change) / 2);
    }
  }
  return false;
}

}  // namespace

void constrained_update(const StepContext& context, Island& island, double time, double h) {
  std::vector<Vector6d> expected;
  for (const SubstepBody* c : island.bodies) expected.push_back(c->predicted);
  const bool agree = linearise(context, island, time, h, hydro::Pieces::coarse);
  // The Jacobian may have missed what is wet of a thin body in waves.
  if (!agree && island.bodies.front()->body().environment.uneven()) {
    for (std::size_t k = 0; k < expected.size(); ++k) island.bodies[k]->predicted = expected[k];
    linearise(context, island, time, h, hydro::Pieces::fine);
  }
  for (SubstepBody* c : island.bodies) c->predicted = c->update.change;
}

}  // namespace engine
