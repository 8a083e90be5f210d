#include "engine/free_step.h"

#include <algorithm>
#include <cmath>

#include "engine/added_inertia.h"
#include "engine/energy.h"
#include "engine/free_motion.h"
#include "engine/kick.h"
#include "engine/wetness.h"

namespace engine {
namespace {

constexpr double kLargestWetTurn = 0.5;   // in a piece [rad]
constexpr double kLargestCrossing = 0.5;  // in a piece, of the body's height
// A load that changes the motion by more than this from one piece to the next, as a part of the
// motion, is taken as a reason to look at the energy.
constexpr double kSuddenLoad = 0.01;
// The same for the motion through the water surface in a piece, as a part of the body's height.
constexpr double kSuddenCrossing = 0.1;
// Difference of the added mass that a piece ends with from that of its pose, as a part of the
// inertia: its energy is uncertain by as much.
constexpr double kUnmetInertia = 1e-4;
constexpr double kSmallestPart = 1.0 / 4096;  // of a step, with a tolerance

struct Piece {
  Motion motion;
  bool sudden = false;  ///< Its loads changed by much, or were stiff.
};

/// True if the kick changes the motion by much more or less than the last one did.
bool is_sudden(const Body& body, const std::optional<Vector6d>& last_B, const Vector6d& kick_B,
               const Vector6d& u, double h) {
  const double radius = body.hull.radius;
  const Vector6d change = h * (kick_B - last_B.value_or(Vector6d::Zero()));
  const double jump = std::hypot(change.head<3>().norm(), radius * change.tail<3>().norm());
  return jump > kSuddenLoad * std::hypot(u.head<3>().norm(), radius * u.tail<3>().norm());
}

/// True if the body moves through the surface by much of its height, or comes to it or leaves it.
bool crosses(const Body& body, const Surroundings& around, const hydro::BodyState& before,
             const hydro::BodyState& after) {
  const double first = lowest_point(body.box_B, before);
  const double last = lowest_point(body.box_B, after);
  const double height =
      after.orientation.toRotationMatrix().row(2).cwiseAbs().dot(body.box_B.sizes());
  if (std::min(first, last) >= around.highest) return false;
  if (std::max(first, last) + height <= around.lowest) return false;
  return std::max(first, last) >= around.highest ||
         std::abs(last - first) > kSuddenCrossing * height;
}

/// The second half of a piece, with the added mass of its end.
Motion finish(const Body& body, const Surroundings& around, const Middle& middle, const Kick& kick,
              const Matrix6d& added_B, double h) {
  const Eigen::Matrix3d R_BW = middle.motion.state.orientation.conjugate().toRotationMatrix();
  Motion next = with_added_mass(middle.motion, added_B, middle.motion.added_B, h);
  next.kick_B = turned(R_BW, kick.change) / h;
  next.state = with_velocity(next.state, middle.after + kick.change, around.current());
  check_state(body, next.state);
  next = drift(body, around, next, h / 2);
  check_state(body, next.state);
  return next;
}

/// Largest part of the inertia that a change of added mass makes up [-].
double part_of_inertia(const Body& body, const Matrix6d& added_B, const Matrix6d& change) {
  return change.cwiseAbs().maxCoeff() / (body.rigid_B + added_B).diagonal().minCoeff();
}

/// The motion with the added mass of its pose where the passes of a piece have not met that, as
/// when a body comes to the water: what it gains shares the momentum (added_inertia.h).
Motion settled(const Body& body, const Surroundings& around, Motion motion,
               const Matrix6d& added_B) {
  const Eigen::Matrix3d R_WB = motion.state.orientation.toRotationMatrix();
  const Matrix6d change = turned_matrix(R_WB, added_B - motion.added_B);
  const Vector6d u = inertia_change(inertia_W(body, motion), change, body.spec->locked,
                                    velocity(motion.state, around.current()))
                         .velocity;
  motion.state = with_velocity(motion.state, u, around.current());
  motion.added_B = added_B;
  motion.added_rate_B.setZero();
  motion.has_added = !added_B.isZero(0);
  return motion;
}

/// Drift, kick, drift; again with the added mass of the end where it is not the expected one.
Piece piece(Body& body, const Surroundings& around, const Motion& motion, double time, double h) {
  const DofMask& locked = body.spec->locked;
  const Motion halfway = drift(body, around, motion, h / 2);
  Matrix6d added_B = expected_added_mass(body, motion, h);
  Middle middle = make_middle(body, around, halfway, added_B, locked);
  Kick kick = free_kick(body, around, middle, time + h / 2, h);
  Piece result{.motion = finish(body, around, middle, kick, added_B, h)};
  bool close = !body.adds;
  for (int pass = 1; !close; ++pass) {
    const Matrix6d found_B = added_mass(body, around, result.motion.state, time + h);
    if (same_added_mass(body, found_B, added_B)) break;
    if (pass == kMostPasses) {
      result.motion = settled(body, around, result.motion, found_B);
      break;
    }
    // What is left of a difference after a pass is this much of the inertia, or less.
    const double off = part_of_inertia(body, added_B, found_B - added_B);
    const double change = part_of_inertia(body, added_B, found_B - motion.added_B);
    close = off * std::max(off, change) <= kUnmetInertia;
    added_B = found_B;
    middle = make_middle(body, around, halfway, added_B, locked);
    kick = free_kick_again(body, around, middle, kick, time + h / 2, h);
    result.motion = finish(body, around, middle, kick, added_B, h);
  }
  result.sudden =
      kick.implicit || (body.wet && (crosses(body, around, motion.state, result.motion.state) ||
                                     is_sudden(body, motion.kick_B, *result.motion.kick_B,
                                               middle.after + kick.change, h)));
  body.cost.implicit += kick.implicit;
  ++body.cost.substeps;
  return result;
}

double kinetic_energy(const Body& body, const Surroundings& around, const Motion& motion) {
  const Vector6d u = velocity(motion.state, around.current());
  return u.dot(inertia_W(body, motion) * u) / 2;
}

/// `after` slowed until it has `excess` less energy; if it has not that much, at rest where it was
/// `before`.
Motion braked(const Body& body, const Surroundings& around, const Motion& before,
              const Motion& after, double excess) {
  const double kinetic = kinetic_energy(body, around, after);
  const bool enough = kinetic > excess;
  const double part = enough ? std::sqrt(1 - excess / kinetic) : 0;
  Motion slowed = enough ? after : before;
  slowed.state = with_velocity(slowed.state, part * velocity(slowed.state, around.current()),
                               around.current());
  slowed.kick_B.reset();
  return slowed;
}

/// A piece that does not add energy.
Motion passive_piece(Body& body, const Surroundings& around, const Motion& motion, double time,
                     double h, int halvings) {
  const Piece whole = piece(body, around, motion, time, h);
  if (!whole.sudden || !must_not_gain_energy(body, around)) return whole.motion;
  const double before = energy(body, around, motion);
  const double excess = energy(body, around, whole.motion) - before;
  const double moved =
      kinetic_energy(body, around, motion) + kinetic_energy(body, around, whole.motion);
  if (excess <= kEnergyGain * moved) return whole.motion;
  if (halvings == 0) {
    ++body.cost.braked;
    return braked(body, around, motion, whole.motion, excess);
  }
  const Motion half = passive_piece(body, around, motion, time, h / 2, halvings - 1);
  return passive_piece(body, around, half, time + h / 2, h / 2, halvings - 1);
}

/// One step in pieces cut by the motion.
Motion cut_step(Body& body, const Surroundings& around, Motion motion, double time, double step) {
  double done = 0;
  while (done < step) {
    const double rest = step - done;
    const double h = piece_length(body, around, motion, rest, step / kMostPieces);
    motion = passive_piece(body, around, motion, time + done, h, kMostHalvings);
    if (h >= rest) break;
    done += h;
  }
  return motion;
}

/// Difference of two motions after the same time h, as a part of the tolerance's measure.
double distance(const Body& body, const Motion& a, const Motion& b, double h) {
  const double radius = std::max(body.box_B.sizes().norm() / 2, 1e-9);
  const Eigen::Vector3d turn = (a.state.orientation * b.state.orientation.conjugate()).vec();
  return std::max({(a.state.position - b.state.position).norm() / radius, 2 * turn.norm(),
                   h * (a.state.linear_velocity - b.state.linear_velocity).norm() / radius,
                   h * (a.state.angular_velocity - b.state.angular_velocity).norm()});
}

/// `fine` with a third of what it differs from `coarse` added.
Motion extrapolated(const Motion& coarse, const Motion& fine) {
  Motion result = fine;
  const hydro::BodyState& a = coarse.state;
  hydro::BodyState& b = result.state;
  b.position += (b.position - a.position) / 3;
  b.linear_velocity += (b.linear_velocity - a.linear_velocity) / 3;
  b.angular_velocity += (b.angular_velocity - a.angular_velocity) / 3;
  const Eigen::AngleAxisd turn(b.orientation * a.orientation.conjugate());
  b.orientation = (Eigen::AngleAxisd(turn.angle() / 3, turn.axis()) * b.orientation).normalized();
  return result;
}

/// One step in pieces whose error is estimated.
Motion controlled_step(Body& body, const Surroundings& around, Motion motion, double time,
                       double step, double tolerance) {
  double done = 0;
  double h = step;
  while (done < step) {
    h = std::min(h, step - done);
    const Motion coarse = cut_step(body, around, motion, time + done, h);
    const Motion half = cut_step(body, around, motion, time + done, h / 2);
    const Motion fine = cut_step(body, around, half, time + done + h / 2, h / 2);
    const double error = distance(body, coarse, fine, h) / 3 / (tolerance * h);
    const bool shortest = h <= step * kSmallestPart;
    if (error <= 1 || shortest) {
      const bool all = h >= step - done;
      motion = body.locked ? fine : extrapolated(coarse, fine);
      if (all) break;
      done += h;
    }
    // The estimate is of the third order in h, a second's share of it of the second.
    h *= std::clamp(0.9 / std::sqrt(std::max(error, 1e-12)), 0.25, 4.0);
    h = std::max(h, step * kSmallestPart);
  }
  return motion;
}

}  // namespace

double piece_length(const Body& body, const Surroundings& around, const Motion& motion, double rest,
                    double shortest) {
  if (!body.wet) return rest;
  const hydro::BodyState& state = motion.state;
  const double low = lowest_point(body.box_B, state);
  const double rise = state.linear_velocity.z() * rest;
  if (std::min(low, low + rise) >= around.highest) return rest;
  double rate = state.angular_velocity.norm() / kLargestWetTurn;
  const double height =
      state.orientation.toRotationMatrix().row(2).cwiseAbs().dot(body.box_B.sizes());
  if (std::max(low, low + rise) + height > around.lowest)
    rate = std::max(rate, std::abs(state.linear_velocity.z()) / (kLargestCrossing * height));
  const double longest = std::max(shortest, rate > 0 ? 1 / rate : rest);
  return rest / std::max(1.0, std::ceil(rest / longest));
}

Motion free_step(Body& body, const Surroundings& around, const Motion& motion, double time,
                 double step, double tolerance) {
  ++body.cost.free_steps;
  return tolerance > 0 ? controlled_step(body, around, motion, time, step, tolerance)
                       : cut_step(body, around, motion, time, step);
}

}  // namespace engine
