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
struct BodyEquation {
  Matrix6d S = Matrix6d::Identity();  ///< Effective inertia.
  Matrix6d mobility;                  ///< Its inverse in the velocities that locks leave.
  Vector6d load;                      ///< F, with the jump as a load.
  Vector6d before;                    ///< u⁻
  Vector6d jump;                      ///< Change of velocity by that of the added mass.
  bool implicit = false;

  Vector6d unconstrained(double h) const { return before + h * mobility * load; }
};

BodyEquation make_equation(const SubstepBody& c, double time, double h, hydro::Pieces pieces) {
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
  const std::vector<BodyEquation>& bodies;
  double h;
};

/// Energy of the motion that the reactions act on, and of the one that loads add [J].
double motion_energy(const Problem& problem) {
  double sum = 0;
  for (const BodyEquation& b : problem.bodies) {
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

/// Forces of the rows of lines and drives, whose blocks come last, and their work.
void add_rows(const Problem& problem, const std::vector<ConstraintBlock>& blocks,
              const ConstraintSolution& found, ConstraintResult& result) {
  const std::size_t rows = problem.island.rows.size();
  for (std::size_t k = blocks.size() - rows; k < blocks.size(); ++k) {
    const double impulse = found.impulses[k][0];
    result.row_forces.push_back(impulse / problem.h);
    for (int side = 0; side < 2; ++side) {
      const auto place = place_in(problem.island, blocks[k].bodies[side]);
      if (!place) continue;
      const BodyEquation& body = problem.bodies[*place];
      const Vector6d mean = (body.before + body.jump + found.velocities[*place]) / 2;
      result.row_work += impulse * blocks[k].J[side].row(0).dot(mean);
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

ConstraintResult solve(const Problem& problem, const Constraints& constraints) {
  const Island& island = problem.island;
  std::vector<ConstrainedBody> bodies;
  bodies.reserve(island.bodies.size());
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const BodyEquation& b = problem.bodies[i];
    bodies.push_back({island.bodies[i]->id, b.S, b.mobility, b.unconstrained(problem.h)});
  }
  const std::vector<ConstraintBlock> blocks = blocks_of(problem, constraints);
  problem.context.check_stop();
  const Stopwatch stopwatch(island.bodies.front()->moving->cache.constraint_seconds);
  const ConstraintSolution found =
      solve_constraints(bodies, blocks, expected_impulses(problem, constraints, blocks),
                        std::sqrt(2 * motion_energy(problem)));
  keep_forces(blocks, found.impulses, problem);
  ConstraintResult result{
      .joints = joint_reactions(problem, constraints.joints, blocks, found.impulses),
      .solved = found.converged};
  result.changes.reserve(bodies.size());
  result.reactions.reserve(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyEquation& b = problem.bodies[i];
    const Vector6d change = found.velocities[i] - b.before;
    result.changes.push_back(change - b.jump);
    result.reactions.push_back(b.S * change / problem.h - b.load);
    island.bodies[i]->moving->counts.iterations += found.sweeps;
  }
  add_rows(problem, blocks, found, result);
  return result;
}

/// The result without any forces of constraints.
ConstraintResult without_reactions(const Problem& problem, ConstraintResult result) {
  for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
    const BodyEquation& b = problem.bodies[i];
    result.changes[i] = b.unconstrained(problem.h) - b.before - b.jump;
    result.reactions[i].setZero();
  }
  std::ranges::fill(result.row_forces, 0);
  result.row_work = 0;
  for (JointReaction& joint : result.joints) joint.force_W = joint.moment_W = {0, 0, 0};
  return result;
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
  for (const BodyEquation& b : problem.bodies) before.push_back(b.before + b.jump);
  return before;
}

/// The result, less what restitution would give of energy (E33).
ConstraintResult without_created_energy(const Problem& problem,
                                        const std::vector<JointFrames>& joints,
                                        ConstraintResult result) {
  if (!has_restitution(problem.island.contacts)) return result;
  const std::vector<Vector6d> before = velocities_before(problem);
  if (!adds_energy(result, before, problem.h, 0)) return result;
  const std::vector<Contact> contacts = without_restitution(problem.island.contacts);
  return limit_energy(solve(problem, {joints, contacts}), result, before, problem.h, 0);
}

/// The result; of one that is not solved only what no more than overlaps give of energy.
ConstraintResult solve(const Problem& problem) {
  std::vector<BodyId> ids;
  for (const SubstepBody* b : problem.island.bodies) ids.push_back(b->id);
  const std::vector<JointFrames> joints = problem.context.world.joints_of(ids);
  ConstraintResult result =
      without_created_energy(problem, joints, solve(problem, {joints, problem.island.contacts}));
  if (result.solved) return result;
  const std::vector<Vector6d> before = velocities_before(problem);
  // A substep as long as kShortestContact may gain the whole amount; shorter ones share it.
  const double fraction = problem.h / std::max(problem.h, kShortestContact);
  const double allowed_gain =
      fraction * (kUnsolvedWork * motion_energy(problem) + overlap_energy(problem));
  if (!adds_energy(result, before, problem.h, allowed_gain)) return result;
  return limit_energy(without_reactions(problem, result), result, before, problem.h, allowed_gain);
}

/// True if the changes agree with those that the loads were linearised about.
bool has_converged(const Problem& problem, const ConstraintResult& result) {
  for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
    const BodyEquation& b = problem.bodies[i];
    if (!b.implicit) continue;
    const Vector6d& change = result.changes[i];
    const Vector6d error = change - problem.island.bodies[i]->predicted;
    if (error.dot(b.S * error) > kNewtonTolerance * kNewtonTolerance * change.dot(b.S * change))
      return false;
  }
  return true;
}

/// Energy of what the changes miss of those that the loads were linearised about.
double missed(const Problem& problem, const ConstraintResult& result) {
  double sum = 0;
  for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
    const BodyEquation& b = problem.bodies[i];
    if (!b.implicit) continue;
    const Vector6d error = result.changes[i] - problem.island.bodies[i]->predicted;
    sum += error.dot(b.S * error);
  }
  return sum;
}

/// Makes the result that of the island.
void keep(const Problem& problem, const ConstraintResult& result) {
  Island& island = problem.island;
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
    SubstepBody& c = *island.bodies[k];
    const BodyEquation& b = problem.bodies[k];
    c.update = {.change = result.changes[k], .implicit = b.implicit, .unsolved = !result.solved};
    c.reaction_B = rotate(c.midpoint.R_WB.transpose(), result.reactions[k]);
    c.load_acceleration_W = (b.mobility * b.load).head<3>();
  }
  for (std::size_t k = 0; k < island.rows.size(); ++k) island.rows[k].force = result.row_forces[k];
  island.reactions = result.joints;
}

/// The state that the loads alone lead a body to.
hydro::BodyState unconstrained_state(const SubstepBody& c, const BodyEquation& b, double h) {
  return with_velocity(c.halfway.state, b.unconstrained(h), Eigen::Vector3d::Zero());
}

/// Solves (E7) for loads that are linearised about the last result, until both agree; where they
/// lead away from each other, the nearest result counts.
/// @return true if they agree
bool linearise(const StepContext& context, Island& island, double time, double h,
               hydro::Pieces pieces) {
  std::vector<BodyEquation> equations(island.bodies.size());
  const Problem problem{.context = context, .island = island, .bodies = equations, .h = h};
  double least = std::numeric_limits<double>::infinity();
  // On fine pieces, half steps lead no nearer.
  const int limit = pieces == hydro::Pieces::fine ? kFullNewtonSteps : kMostLinearisations;
  for (int i = 0; i < limit; ++i) {
    parallel_for_rethrow(context.parallel_for, equations.size(), [&](std::size_t k) {
      context.check_stop();
      equations[k] = make_equation(*island.bodies[k], time, h, pieces);
    });
    for (std::size_t k = 0; k < equations.size(); ++k) {
      const hydro::BodyState state = unconstrained_state(*island.bodies[k], equations[k], h);
      // Loads that lead beyond all bounds are a fault of the motion only where none led elsewhere.
      if (i == 0 && pieces == hydro::Pieces::coarse)
        check_state(*island.bodies[k]->moving, state);
      else if (state_fault(state))
        return false;
    }
    const ConstraintResult result = solve(problem);
    const bool done = has_converged(problem, result);
    const double error = missed(problem, result);
    if (done || !(error >= least)) keep(problem, result);
    if (done) return true;
    if (error > kNewtonDiverged * least) return false;
    least = std::min(least, error);
    for (std::size_t k = 0; k < equations.size(); ++k) {
      // Where Newton's method alternates, the mean is nearer.
      Vector6d& predicted = island.bodies[k]->predicted;
      const Vector6d& change = result.changes[k];
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
