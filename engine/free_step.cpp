#include "engine/free_step.h"

#include <algorithm>
#include <cmath>

#include "engine/added_inertia.h"
#include "engine/energy.h"
#include "engine/error_control.h"
#include "engine/free_motion.h"
#include "engine/kick.h"
#include "engine/wetness.h"

namespace engine {
namespace {

constexpr double kLargestWetTurn = 0.5;     // in a piece [rad]
constexpr double kLargestCrossing = 0.5;    // in a piece, of the body's height
constexpr double kLargestSwing = 0.25;      // in a piece [rad]
constexpr double kShortestSwing = 1.0 / 8;  // of the step
// Motions are cut if they move a body by more than this part of its radius in a step.
constexpr double kSmallestSwing = 1e-6;
// A load that changes the motion by more than this from one piece to the next, as a part of the
// motion, is taken as a reason to look at the energy.
constexpr double kSuddenLoad = 0.01;
// The same for the motion through the water surface in a piece, as a part of the body's height.
constexpr double kSuddenCrossing = 0.1;
constexpr double kStartingPart = 1.0 / 8;     // of the step
constexpr double kSmallestPart = 1.0 / 4096;  // of a step, with a tolerance

struct Piece {
  Motion motion;
  bool sudden = false;  ///< Its loads changed by much, or were stiff.
};

/// True if the kick changes the motion by much more or less than the last ones foretell.
bool is_sudden(const Body& body, const KickHistory& last, const Kick& kick,
               const Eigen::Matrix3d& R_BW, const Vector6d& u, double h) {
  const double radius = body.radius;
  const Vector6d off = turned(R_BW, kick.change) - h * last.expected(h / 2);
  const double jump = size(off, radius);
  return jump > kSuddenLoad * size(u, radius);
}

bool turns_about(const Body& body) { return body.guide && body.guide->turns(); }

/// True if a piece turns a body by so much that loads on its way are not those halfway.
bool turns_far(const hydro::BodyState& after, double h) {
  return after.angular_velocity.norm() * h > kLargestSwing;
}

/// How a body has moved relative to what the water surface never leaves.
struct Passage {
  bool meets;     ///< It may have met the surface.
  bool enters;    ///< Or it has come to it or left it.
  double rise;    ///< [m]
  double height;  ///< The body's own [m].
};

Passage passage(const Body& body, const Surroundings& around, const hydro::BodyState& before,
                const hydro::BodyState& after) {
  const double first = lowest_point(body.box_B, before);
  const auto [last, height] = extent_of(body.box_B, after);
  return {.meets = std::min(first, last) < around.highest &&
                   std::max(first, last) + height > around.lowest,
          .enters = std::max(first, last) >= around.highest,
          .rise = last - first,
          .height = height};
}

/// True if the body moves through the surface by much of its height, or comes to it or leaves it.
bool crosses(const Body& body, const Surroundings& around, const hydro::BodyState& before,
             const hydro::BodyState& after) {
  const Passage p = passage(body, around, before, after);
  return p.meets && (p.enters || std::abs(p.rise) > kSuddenCrossing * p.height);
}

/// The second half of a piece, with the added mass of its end.
Motion finish(const Body& body, const Surroundings& around, const Middle& middle, const Kick& kick,
              const Matrix6d& added_B, double h) {
  const Eigen::Matrix3d R_BW = middle.R_WB.transpose();
  Motion next = *middle.motion;
  if (body.adds) set_added_mass(next, added_B, h);
  // An implicit kick is of another kind: explicit ones do not follow from it.
  if (kick.implicit || kick.sudden) next.kicks.clear();
  next.kicks.add(1 / h * turned(R_BW, kick.change), h, body.radius);
  if (!kick.implicit) next.kicks.set_slope(turned(R_BW, kick.slope));
  next.state = with_velocity(next.state, middle.after + kick.change, around.current());
  check_state(body, next.state);
  if (next.ledger)
    book_kick(body, around, middle, {.change = kick.change, .step = h, .implicit = kick.implicit},
              next);
  drift(body, around, next, h / 2);
  check_state(body, next.state);
  return next;
}

/// What the state that equation (1) of kick.h moves on is beyond the one that is seen, in W.
struct Offset {
  Vector6d pose;
  Vector6d velocity;
};

/// True if the kicks of the body come to show a trend.
bool shows_trend(const Body& body, const Motion& motion) {
  return (body.wet || body.guide) && !motion.constrained;
}

/// (2) of free_step.h by the trend of the last kicks; none if they do not show it.
std::optional<Offset> find_offset(const Body& body, const Motion& motion, double h) {
  if (!shows_trend(body, motion) || !motion.kicks.resolved()) return std::nullopt;
  const KickHistory::Trend trend = motion.kicks.trend();
  const Eigen::Matrix3d R_WB = motion.state.orientation.toRotationMatrix();
  const Eigen::Vector3d spin = motion.state.angular_velocity;
  const Vector6d a = turned(R_WB, trend.value);
  const Vector6d turning = stacked(spin.cross(a.head<3>()), spin.cross(a.tail<3>()));
  return Offset{h * h / 24 * a, -h * h / 24 * (turned(R_WB, trend.slope) + turning)};
}

void add_offset(const Body& body, const Offset& offset, double sign, Motion& motion) {
  motion.state = displaced(body, motion.state, sign * offset.pose);
  motion.state.linear_velocity += sign * offset.velocity.head<3>();
  motion.state.angular_velocity += sign * offset.velocity.tail<3>();
  if (body.guide) motion.state = guided(*body.guide, motion.state);
}

/// Drift, kick, drift; again with the added mass of the end where it is not the expected one.
Piece bare_piece(Body& body, const Surroundings& around, const Motion& motion, double time,
                 double h) {
  Motion halfway = motion;
  drift(body, around, halfway, h / 2);
  const Freedom left = body.adds ? freedom(body, halfway.state) : Freedom{};
  Matrix6d added_B;  // Of no use to a body without it.
  if (body.adds) added_B = expected_added_mass(body, motion, h);
  Middle middle = make_middle(body, around, halfway, added_B, left);
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
    close = nearly_met(body, motion.added(), added_B, found_B);
    added_B = found_B;
    middle = make_middle(body, around, halfway, added_B, left);
    kick = free_kick_again(body, around, middle, kick, time + h / 2, h);
    result.motion = finish(body, around, middle, kick, added_B, h);
  }
  result.sudden =
      kick.implicit || (body.wet && (turns_far(result.motion.state, h) ||
                                     crosses(body, around, motion.state, result.motion.state) ||
                                     (!result.motion.kicks.resolved() &&
                                      is_sudden(body, motion.kicks, kick, middle.R_WB.transpose(),
                                                middle.after + kick.change, h))));
  body.cost.implicit += kick.implicit;
  ++body.cost.substeps;
  return result;
}

/// A piece from and to states that are seen: what is added at its start is taken off at its end, by
/// the trend that the kicks show there.
Piece piece(Body& body, const Surroundings& around, const Motion& motion, double time, double h) {
  const std::optional<Offset> before = find_offset(body, motion, h);
  if (!before) return bare_piece(body, around, motion, time, h);
  Motion unseen = motion;
  add_offset(body, *before, 1, unseen);
  Piece result = bare_piece(body, around, unseen, time, h);
  const Offset after = find_offset(body, result.motion, h).value_or(*before);
  add_offset(body, after, -1, result.motion);
  return result;
}

/// The motion slowed until it has `excess` less of its `kinetic` energy.
Motion slowed(const Body& body, const Surroundings& around, const Motion& motion, double kinetic,
              double excess) {
  const double part = kinetic > excess ? std::sqrt(1 - excess / kinetic) : 0;
  Motion slow = motion;
  slow.state = with_velocity(motion.state, part * velocity(motion.state, around.current()),
                             around.current());
  if (slow.ledger) book_brake(body, around, motion, slow);
  return slow;
}

/// The same where pieces of no length help; what has not that much energy rests where it was
/// `before`.
Motion braked(const Body& body, const Surroundings& around, const Motion& before,
              const Motion& after, double kinetic, double excess) {
  Motion motion = slowed(body, around, kinetic > excess ? after : before, kinetic, excess);
  motion.kicks.clear();
  return motion;
}

/// A piece in which the water gives no more energy than it can, and throws the body nowhere.
/// @param shortest   That it may be halved to [s].
/// @param half       It was halved.
void sound_piece(Body& body, const Surroundings& around, Motion& motion, double time, double h,
                 double shortest, bool half = false) {
  const bool divisible = h / 2 >= shortest;
  const auto in_halves = [&] {
    sound_piece(body, around, motion, time, h / 2, shortest, true);
    sound_piece(body, around, motion, time + h / 2, h / 2, shortest, true);
  };
  Piece whole = piece(body, around, motion, time, h);
  // Of what was halved for its energy each part is looked at.
  if (!whole.sudden && !half) {
    motion = whole.motion;
    return;
  }
  if (whole.sudden && divisible && leaps(body, around, motion.state, whole.motion.state, h))
    return in_halves();
  if (!must_not_gain_energy(body, around)) {
    motion = whole.motion;
    return;
  }
  EnergyRange range = motion.energy;
  const double potential = potential_energy(body, around, motion.state);
  const double before = potential + kinetic_energy(body, around, motion);
  range.extend(before, potential);
  if (is_driven(body))
    range.lowest = before + work_done(body, around, motion.state, whole.motion.state, h);
  const double after = potential_energy(body, around, whole.motion.state);
  const double kinetic = kinetic_energy(body, around, whole.motion);
  const double energy = after + kinetic;
  const double allowed = range.allowed_gain(least_energy_scale(body, around));
  const double excess = energy - range.lowest - allowed;
  if (excess > allowed) {
    if (divisible && can_be_followed(body, around, motion, h)) return in_halves();
    ++body.cost.braked;
    whole.motion = braked(body, around, motion, whole.motion, kinetic, excess);
  } else if (excess > 0 && kinetic > excess) {
    whole.motion = slowed(body, around, whole.motion, kinetic, excess);
  }
  range.extend(std::min(energy, energy - excess), after);
  motion = whole.motion;
  motion.energy = range;
}

/// Length of the first of the equal pieces in which the rest of a step resolves the body's swing.
double swing_length(const Body& body, const Motion& motion, double rest, double shortest) {
  if (!body.wet || motion.kicks.pace() * rest <= kLargestSwing) return rest;
  const Eigen::Vector3d a = motion.kicks.expected(0).head<3>();
  if (a.norm() * rest * rest < kSmallestSwing * body.radius) return rest;
  const double longest = std::max(shortest, kLargestSwing / motion.kicks.pace());
  return rest / std::max(1.0, std::ceil(rest / longest));
}

/// Length of the first of the equal pieces in which the rest of a step is to be taken.
double next_length(const Body& body, const Surroundings& around, const Motion& motion, double rest,
                   double step) {
  return std::min(piece_length(body, around, motion, rest, step / kMostPieces),
                  swing_length(body, motion, rest, kShortestSwing * step));
}

/// One step in pieces cut by the motion. The first ones of a motion, which are of lower order until
/// their kicks show a trend, are short.
void cut_step(Body& body, const Surroundings& around, Motion& motion, double time, double step,
              double shortest) {
  const bool starts = motion.kicks.empty() && shows_trend(body, motion) &&
                      (body.guide || lowest_point(body.box_B, motion.state) < around.highest);
  double done = 0;
  for (int i = 0; done < step; ++i) {
    const double rest = step - done;
    double h = next_length(body, around, motion, rest, step);
    if (starts && i < KickHistory::kTrend) h = std::min(h, kStartingPart * step);
    sound_piece(body, around, motion, time + done, h, shortest);
    if (h >= rest) break;
    done += h;
  }
}

/// One step in pieces whose error is estimated.
void controlled_step(Body& body, const Surroundings& around, Motion& motion, double time,
                     double step, double shortest, double tolerance) {
  double done = 0;
  double h = step;
  while (done < step) {
    h = next_length(body, around, motion, std::min(h, step - done), step);
    // Both must be cut by the tolerance alone, or they could be the same pieces.
    const Motion coarse = piece(body, around, motion, time + done, h).motion;
    Motion fine = motion;
    sound_piece(body, around, fine, time + done, h / 2, shortest);
    sound_piece(body, around, fine, time + done + h / 2, h / 2, shortest);
    const double error = estimated_error(body, coarse, fine, h, tolerance);
    if (error <= 1 || h <= step * kSmallestPart) {
      const bool all = h >= step - done;
      motion = fine;
      if (all) break;
      done += h;
    }
    h = std::max(length_for_error(h, error), step * kSmallestPart);
  }
}

}  // namespace

double piece_length(const Body& body, const Surroundings& around, const Motion& motion, double rest,
                    double shortest) {
  if (!body.wet) return rest;
  const hydro::BodyState& state = motion.state;
  const auto [low, height] = extent_of(body.box_B, state);
  const double rise = state.linear_velocity.z() * rest;
  // On a hinge it comes round, wherever it goes.
  const double round = turns_about(body) ? state.linear_velocity.norm() * rest : 0;
  if (std::min(low, low + rise) - round >= around.highest) return rest;
  double rate = state.angular_velocity.norm() / kLargestWetTurn;
  if (std::max(low, low + rise) + height > around.lowest)
    rate = std::max(rate, std::abs(state.linear_velocity.z()) / (kLargestCrossing * height));
  const double longest = std::max(shortest, rate > 0 ? 1 / rate : rest);
  return rest / std::max(1.0, std::ceil(rest / longest));
}

double own_turning_rate(const Body& body, const Surroundings& around, const Motion& motion) {
  const Eigen::Matrix3d R_BW = motion.state.orientation.conjugate().toRotationMatrix();
  return turning_rate(body.rigid_B + motion.added(),
                      turned(R_BW, velocity(motion.state, around.current())));
}

bool can_be_followed(const Body& body, const Surroundings& around, const Motion& motion, double h) {
  return own_turning_rate(body, around, motion) * h < kFollowedTurn;
}

bool leaps(const Body& body, const Surroundings& around, const hydro::BodyState& before,
           const hydro::BodyState& after, double h) {
  const Passage p = passage(body, around, before, after);
  const double thrown = h / 2 * (after.linear_velocity.z() - before.linear_velocity.z());
  return p.meets && std::min(std::abs(p.rise), std::abs(thrown)) > kLongestLeap * p.height;
}

void free_step(Body& body, const Surroundings& around, double time, double step, double shortest,
               double tolerance) {
  ++body.cost.free_steps;
  if (tolerance > 0)
    controlled_step(body, around, body.motion, time, step, shortest, tolerance);
  else
    cut_step(body, around, body.motion, time, step, shortest);
}

}  // namespace engine
