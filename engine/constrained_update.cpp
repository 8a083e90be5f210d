#include "engine/constrained_update.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/anderson.h"
#include "engine/constants.h"
#include "engine/restitution.h"
#include "hydro/decompositions.h"

namespace engine {
namespace {

/// What (E8) needs of one body, in W.
struct Row {
  Matrix6d S = Matrix6d::Identity();  ///< Effective inertia.
  hydro::Cholesky6 S_factor{S};
  Vector6d load;      ///< F
  Vector6d jump;      ///< Change of velocity by that of the added mass.
  SolverBody solver;  ///< M_o, state.
  Matrix6d M_o = Matrix6d::Identity();
  hydro::Cholesky6 root{M_o};  ///< Of M_o.
  bool implicit = false;
  bool plain = false;  ///< S = M_o.
};

Eigen::Matrix3d symmetric(const Eigen::Matrix3d& m) { return (m + m.transpose()) / 2; }

/// M_o: `factor` times the nearest that ODE can take.
void choose_solver_mass(const SubstepBody& c, Row& row, double factor) {
  const Eigen::Matrix3d& R_WB = c.midpoint.R_WB;
  const bool own = !c.body().has_added_mass && !row.implicit && !c.midpoint.rig_inertia;
  const Matrix6d S_B = own ? c.body().rigid_B : rotate_tensor(R_WB.transpose(), row.S);
  const Eigen::Matrix3d translation = S_B.topLeftCorner<3, 3>();
  const double mean = own ? c.body().spec->mass : std::cbrt(hydro::eigenvalues(translation).prod());
  row.solver.mass = factor * mean;
  row.solver.inertia_B = factor * symmetric(S_B.bottomRightCorner<3, 3>());
  Matrix6d M_B = Matrix6d::Zero();
  M_B.diagonal().head<3>().setConstant(row.solver.mass);
  M_B.bottomRightCorner<3, 3>() = row.solver.inertia_B;
  row.plain = own || (M_B - S_B).cwiseAbs().maxCoeff() <= 1e-14 * S_B.cwiseAbs().maxCoeff();
  row.M_o = rotate_tensor(R_WB, M_B);
  row.root = hydro::Cholesky6(row.M_o);
}

Row make_row(const SubstepBody& c, double time, double h) {
  const EffectiveLoad effective = effective_load(*c.moving, c.midpoint, c.predicted, time, h);
  const hydro::BodyState& state = c.halfway.state;
  const Vector6d jump = c.midpoint.after - c.midpoint.before;
  Row row{.S = effective.inertia,
          .S_factor = hydro::Cholesky6(effective.inertia),
          .load = effective.load + effective.inertia * jump / h,
          .jump = jump,
          .solver = {.body = c.id, .state = state},
          .implicit = effective.implicit};
  choose_solver_mass(c, row, 1);
  const Eigen::Vector3d still = Eigen::Vector3d::Zero();
  const Vector6d unconstrained = velocity(state, still) + h * row.S_factor.solve(row.load);
  check_state(*c.moving, with_velocity(state, unconstrained, still));
  return row;
}

/// Largest number that M_o may be multiplied with so that M_o <= S.
double contraction_factor(const Row& row) {
  return std::min(1.0, hydro::eigenvalues(row.root.relative(row.S))[0]);
}

/// The constraints of an island.
struct Solver {
  World& world;
  const std::vector<Contact>& contacts;
  const std::vector<ForceRow>& rows;
};

/// An answer of the solver to the reactions r: the changes of velocity, and R.
using Answer = ImpactAnswer;

Answer ask(const Solver& solver, std::vector<Row>& rows, const std::vector<Vector6d>& r,
           double step) {
  std::vector<SolverBody> bodies;
  std::vector<Vector6d> loads;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows[i];
    loads.push_back(row.plain ? row.load
                              : Vector6d(row.M_o * row.S_factor.solve(row.load + r[i]) - r[i]));
    row.solver.load = to_wrench(loads.back());
    bodies.push_back(row.solver);
  }
  World::ConstrainedMotion motion =
      solver.world.constrained_motion(bodies, solver.contacts, solver.rows, step);
  const std::vector<hydro::Twist>& after = motion.velocities;
  Answer answer{.row_forces = std::move(motion.forces), .joints = std::move(motion.reactions)};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const hydro::BodyState& before = rows[i].solver.state;
    const Vector6d change = to_vector6(after[i].linear - before.linear_velocity,
                                       after[i].angular - before.angular_velocity);
    answer.changes.push_back(change - rows[i].jump);
    answer.reactions.push_back(rows[i].M_o * change / step - loads[i]);
  }
  return answer;
}

/// Reactions of the bodies that iterate, as changes of velocity in the metric of M_o.
Eigen::VectorXd scaled(const std::vector<Row>& rows, const std::vector<Vector6d>& reactions,
                       double step) {
  Eigen::VectorXd x(6 * static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vector6d part = rows[i].root.solve_lower(reactions[i]);
    x.segment<6>(6 * static_cast<Eigen::Index>(i)) =
        rows[i].plain ? Vector6d(Vector6d::Zero()) : Vector6d(step * part);
  }
  return x;
}

std::vector<Vector6d> unscaled(const std::vector<Row>& rows, const Eigen::VectorXd& x,
                               double step) {
  std::vector<Vector6d> reactions;
  for (std::size_t i = 0; i < rows.size(); ++i)
    reactions.push_back(rows[i].root.lower() * x.segment<6>(6 * static_cast<Eigen::Index>(i)) /
                        step);
  return reactions;
}

/// A measure of the motion that the reactions act on, as `scaled`.
double motion_size(const std::vector<Row>& rows, double step) {
  double sum = 0;
  for (const Row& row : rows) {
    const hydro::BodyState& state = row.solver.state;
    const Vector6d u = to_vector6(state.linear_velocity, state.angular_velocity);
    const Vector6d push = row.root.solve_lower(step * row.load);
    sum += u.dot(row.M_o * u) + push.squaredNorm();
  }
  return std::sqrt(sum);
}

struct Iteration {
  Answer answer;  ///< The one that was nearest to what it was asked with.
  int count = 0;
  bool converged = false;
};

/// r ← R from `start`, accelerated. Ends without success where it gets no nearer.
///
/// @param most        Solutions at most.
/// @param contracts   The plain iteration does. It then takes the place of an acceleration that has
///   led farther away, as across the limit of a contact, where what was learnt does not hold.
Iteration iterate(const Solver& solver, std::vector<Row>& rows, const std::vector<Vector6d>& start,
                  double step, int most, bool contracts) {
  const double size = motion_size(rows, step);
  Eigen::VectorXd x = scaled(rows, start, step), last_x, last_image;
  Anderson anderson(kAndersonDepth);
  Iteration iteration;
  double least = std::numeric_limits<double>::infinity();
  double last = least;
  int idle = 0, plain = 0;
  bool accelerated = false;
  while (true) {
    Answer answer = ask(solver, rows, unscaled(rows, x, step), step);
    ++iteration.count;
    const Eigen::VectorXd image = scaled(rows, answer.reactions, step);
    const double missed = (image - x).norm();
    iteration.converged = missed <= kReactionTolerance * (size + image.norm());
    idle = missed < kProgress * least ? 0 : idle + 1;
    if (missed < least || iteration.count == 1) iteration.answer = std::move(answer);
    least = std::min(least, missed);
    const bool gives_up = iteration.count == most || (!contracts && idle > kMostIdleSolves);
    if (iteration.converged || gives_up) return iteration;
    if (contracts && accelerated && missed >= last) {
      anderson = Anderson(kAndersonDepth);
      x = anderson.next(last_x, last_image);
      plain = 1;
      accelerated = false;
      continue;
    }
    last = missed;
    last_x = x;
    last_image = image;
    const Eigen::VectorXd next = anderson.next(x, image);
    accelerated = plain == 0;
    x = accelerated ? next : image;
    plain = std::max(0, plain - 1);
  }
}

std::vector<Vector6d> last_reactions(const Island& island) {
  std::vector<Vector6d> reactions;
  for (const SubstepBody* c : island.bodies)
    reactions.push_back(rotate(c->midpoint.R_WB, c->reaction_B));
  return reactions;
}

/// (E7) for the loads of the rows. Adds the number of solves to `solves`.
Answer solve(const Solver& solver, const Island& island, std::vector<Row>& rows, double step,
             int& solves) {
  std::vector<Vector6d> start = last_reactions(island);
  if (std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.plain; })) {
    for (const SubstepBody* c : island.bodies) ++c->moving->counts.iterations;
    ++solves;
    return ask(solver, rows, start, step);
  }
  Iteration iteration = iterate(solver, rows, start, step, kMostSolves - kContractingSolves, false);
  int count = iteration.count;
  if (!iteration.converged) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (!rows[i].plain)
        choose_solver_mass(*island.bodies[i], rows[i], contraction_factor(rows[i]));
    iteration = iterate(solver, rows, iteration.answer.reactions, step, kMostSolves - count, true);
    count += iteration.count;
  }
  solves += count;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    island.bodies[i]->moving->counts.iterations += count;
    island.bodies[i]->moving->counts.unconverged += !iteration.converged;
  }
  return iteration.answer;
}

/// The answer, less what restitution would give of energy (E33).
Answer without_gain(const Solver& solver, const Island& island, std::vector<Row>& rows,
                    const Answer& answer, double step, int& solves) {
  if (!restores(solver.contacts)) return answer;
  std::vector<Vector6d> before;
  for (const Row& row : rows)
    before.push_back(velocity(row.solver.state, Eigen::Vector3d::Zero()) + row.jump);
  if (!gains(answer, before, step)) return answer;
  const std::vector<Contact> plain = without_restitution(solver.contacts);
  const Answer stopped = solve({.world = solver.world, .contacts = plain, .rows = solver.rows},
                               island, rows, step, solves);
  return without_gain(stopped, answer, before, step);
}

/// True if the changes agree with those that the loads were linearised about.
bool has_converged(const Island& island, const std::vector<Row>& rows, const Answer& answer) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].implicit) continue;
    const Vector6d& change = answer.changes[i];
    const Vector6d off = change - island.bodies[i]->predicted;
    if (off.dot(rows[i].S * off) >
        kNewtonTolerance * kNewtonTolerance * change.dot(rows[i].S * change))
      return false;
  }
  return true;
}

}  // namespace

void constrained_update(const StepContext& context, Island& island, double time, double h) {
  const Solver solver{.world = context.world, .contacts = island.contacts, .rows = island.rows};
  const std::vector<SubstepBody*>& bodies = island.bodies;
  int solves = 0;
  for (int i = 0; i < kMostLinearisations && solves < kMostSolvesInAll; ++i) {
    std::vector<Row> rows(bodies.size());
    parallel_for_rethrow(context.parallel_for, bodies.size(),
                         [&](std::size_t k) { rows[k] = make_row(*bodies[k], time, h); });
    const Answer answer =
        without_gain(solver, island, rows, solve(solver, island, rows, h, solves), h, solves);
    const bool done = has_converged(island, rows, answer);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      SubstepBody& c = *bodies[k];
      const Vector6d& change = answer.changes[k];
      c.update = {.change = change, .implicit = rows[k].implicit};
      // Where Newton's method alternates, the mean is nearer.
      c.predicted = i < kFullNewtonSteps ? change : Vector6d((c.predicted + change) / 2);
      c.reaction_B = rotate(c.midpoint.R_WB.transpose(), answer.reactions[k]);
      c.load_acceleration_W = rows[k].S_factor.solve(rows[k].load).head<3>();
    }
    for (std::size_t k = 0; k < island.rows.size(); ++k)
      island.rows[k].force = answer.row_forces[k];
    island.reactions = answer.joints;
    if (done) break;
  }
  for (SubstepBody* c : bodies) c->predicted = c->update.change;
}

}  // namespace engine
