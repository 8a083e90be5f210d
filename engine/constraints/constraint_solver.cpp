#include "engine/constraints/constraint_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/base/constants.h"
#include "engine/constraints/anderson.h"
#include "engine/constraints/constraint_newton.h"
#include "engine/constraints/prepared_block.h"

namespace engine {
namespace {

using Eigen::Vector3d;

/// An island with its impulses, and the velocities that they lead to.
struct Iterate {
  const std::vector<ConstrainedBody>& bodies;
  const std::vector<PreparedBlock>& blocks;
  std::vector<Vector3d> impulses;
  std::vector<Vector6d> velocities;
  std::vector<Vector6d> before = {};  ///< The last sweep.
};

/// (E36)
void find_velocities(Iterate& it) {
  for (std::size_t i = 0; i < it.bodies.size(); ++i) it.velocities[i] = it.bodies[i].velocity;
  for (std::size_t k = 0; k < it.blocks.size(); ++k)
    it.blocks[k].push(it.impulses[k], it.velocities);
}

/// Root of the energy of the change of velocities by the last sweep.
double change_size(const Iterate& it) {
  double sum = 0;
  for (std::size_t i = 0; i < it.bodies.size(); ++i) {
    const Vector6d change = it.velocities[i] - it.before[i];
    sum += change.dot(it.bodies[i].inertia * change);
  }
  return std::sqrt(sum);
}

/// Solves every block once. @return the root of the energy of the change
double sweep(Iterate& it, bool forward) {
  const std::size_t count = it.blocks.size();
  it.before = it.velocities;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = forward ? i : count - 1 - i;
    const PreparedBlock& block = it.blocks[k];
    const Vector3d found = block.solved(it.impulses[k], it.velocities);
    const Vector3d step = found - it.impulses[k];
    block.push(step, it.velocities);
    it.impulses[k] = found;
  }
  return change_size(it);
}

/// The impulses in units in which the square of a change is its energy.
Eigen::VectorXd scaled(const Iterate& it) {
  Eigen::VectorXd x(3 * static_cast<Eigen::Index>(it.blocks.size()));
  for (std::size_t k = 0; k < it.blocks.size(); ++k)
    x.segment<3>(3 * static_cast<Eigen::Index>(k)) =
        it.impulses[k].cwiseProduct(it.blocks[k].scale());
  return x;
}

void set_scaled(const Eigen::VectorXd& x, Iterate& it) {
  for (std::size_t k = 0; k < it.blocks.size(); ++k)
    it.impulses[k] =
        x.segment<3>(3 * static_cast<Eigen::Index>(k)).cwiseQuotient(it.blocks[k].scale());
  find_velocities(it);
}

/// Sweeps, and between them Newton steps, until the velocities stay.
class Iteration {
 public:
  Iteration(Iterate& iterate, double size)
      : it_(iterate),
        size_(size),
        jointed_(std::ranges::any_of(
            it_.blocks, [](const PreparedBlock& block) { return block.kind() != Kind::contact; })),
        few_(3 * it_.blocks.size() <= (jointed_ ? kMostNewtonRows : kMostContactRows)),
        takes_newton_steps_(few_),
        solved_(size * (jointed_ ? kSolvedIsland
                        : few_   ? kSolvedContacts
                                 : kSolvedHeap)) {}

  ConstraintSolution run() {
    missed_ = swept();
    if (takes_newton_steps_) take_newton_steps();
    while (!converged() && sweeps_ < (accepted() || jointed_ ? kMostSweeps : kMostHeapSweeps)) {
      take_sweeps(jointed_ ? kSweepsOfJoints : kSweepsOfContacts);
      if (takes_newton_steps_ && !converged()) take_newton_steps();
    }
    return {.velocities = std::move(it_.velocities),
            .impulses = std::move(it_.impulses),
            .sweeps = sweeps_,
            .converged = accepted()};
  }

 private:
  using Kind = ConstraintBlock::Kind;

  bool accepted() const { return missed_ <= kToleratedResidual * size_; }
  bool converged() const { return missed_ <= solved_; }

  double swept() {
    ++sweeps_;
    return sweep(it_, sweeps_ % 2 == 1);
  }

  /// Newton steps, each with a sweep. One may lead farther away and the next nearer, as the rows at
  /// a bound become known; the nearest is kept.
  void take_newton_steps() {
    Iterate nearest = it_;
    const double start = missed_;
    double least = start;
    for (int i = 0; i < kMostRowSteps && !converged(); ++i) {
      auto next = newton_step(it_.blocks, it_.impulses, it_.velocities);
      if (!next) break;
      it_.impulses = *std::move(next);
      find_velocities(it_);
      missed_ = swept();
      if (!(missed_ < least)) continue;
      least = missed_;
      nearest.impulses = it_.impulses;
      nearest.velocities = it_.velocities;
    }
    it_.impulses = std::move(nearest.impulses);
    it_.velocities = std::move(nearest.velocities);
    // Where they lead nowhere once, as under constraints that contradict each other, they do again.
    takes_newton_steps_ = least < start;
    missed_ = least;
  }

  /// Pairs of sweeps there and back, accelerated. Where that gets on slowly, as where friction
  /// grows a little in each until it is at its limit, the last step is taken several times at once,
  /// each time twice as often, until it has led too far.
  void take_sweeps(int count) {
    Anderson anderson(kAndersonDepth);
    double stride = 1;
    for (int i = 2; i <= count && !converged(); i += 2) {
      const Eigen::VectorXd x = scaled(it_);
      swept();
      const double missed = swept();
      const double progress = missed / missed_;
      missed_ = missed;
      if (converged() || i + 2 > count) return;
      if (progress < kAndersonBelow) {
        set_scaled(anderson.next(x, scaled(it_)), it_);
        continue;
      }
      anderson = Anderson(kAndersonDepth);
      stride = progress < kRestartAbove ? 2 * stride : 1;
      const Eigen::VectorXd image = scaled(it_);
      if (stride > 1) set_scaled(image + stride * (image - x), it_);
    }
  }

  Iterate& it_;
  double size_;
  bool jointed_;
  bool few_;  ///< The blocks are few enough for Newton steps.
  bool takes_newton_steps_;
  double solved_;
  double missed_ = 0;  ///< Change by the last sweep.
  int sweeps_ = 0;
};

}  // namespace

ConstraintSolution solve_constraints(const std::vector<ConstrainedBody>& bodies,
                                     const std::vector<ConstraintBlock>& blocks,
                                     const std::vector<Vector3d>& start, double size) {
  assert(start.empty() || start.size() == blocks.size());
  std::vector<PreparedBlock> prepared;
  prepared.reserve(blocks.size());
  for (const ConstraintBlock& block : blocks) prepared.emplace_back(block, bodies);
  Iterate iterate{.bodies = bodies,
                  .blocks = prepared,
                  .impulses = start,
                  .velocities = std::vector<Vector6d>(bodies.size())};
  iterate.impulses.resize(blocks.size(), Vector3d::Zero());
  find_velocities(iterate);
  return Iteration(iterate, size).run();
}

}  // namespace engine
