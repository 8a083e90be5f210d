#include "engine/free_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/added_inertia.h"
#include "engine/constants.h"
#include "engine/locks.h"
#include "hydro/decompositions.h"

namespace engine {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// a of (E2).
double half_step(double speed, double time) {
  const double half = speed * time / 2;
  return half < 1e-4 ? time / 2 * (1 + half * half / 3) : std::tan(half) / speed;
}

/// Number of equal pieces in which no rate [rad/s] turns further than kLargestTurn.
int pieces(double rate, double time) {
  return static_cast<int>(
      std::clamp(std::ceil(rate * time / kLargestTurn), 1.0, 1.0 * kMostDriftParts));
}

/// What turns with the body in (E2): momentum in B and the attitude.
struct Momentum {
  Vector6d p = Vector6d::Zero();
  Matrix3d R = Matrix3d::Identity();
  Vector3d x = Vector3d::Zero();
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
};

/// Rate of change of p by (E1).
Vector6d kirchhoff(const Vector6d& p, const Vector6d& u) {
  const Vector3d P = p.head<3>(), L = p.tail<3>(), v = u.head<3>(), w = u.tail<3>();
  return to_vector6(P.cross(w), L.cross(w) + P.cross(v));
}

/// Displacement (E3) in B axes of the start.
Vector3d displacement(const Vector6d& u, const Vector3d& P0, const Vector3d& P, double a,
                      double time) {
  const Vector3d v = u.head<3>(), w = u.tail<3>();
  const double b = 2 * a / (1 + a * a * w.squaredNorm());
  const double P2 = P.squaredNorm();
  const Vector3d straight = P2 > 0 ? Vector3d(v.dot(P) / P2 * P0) : v;
  return b * (v + a * w.cross(v)) + (time - b) * straight;
}

/// True if the momentum p₁ has the energy of p₀, which an exact solution of (E2) keeps.
bool keeps_energy(const Matrix6d& S_inverse, const Vector6d& p0, const Vector6d& p1) {
  const double before = p0.dot(S_inverse * p0);
  return std::abs(p1.dot(S_inverse * p1) - before) <= kDriftEnergyKept * before;
}

/// [v]×, the matrix of v × .
Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// Derivative of p − p₀ − a (P × ω, L × ω + P × v) by p, with u = S⁻¹ p: that of (E2), a held.
Matrix6d slope(const Matrix6d& S_inverse, const Vector6d& p, const Vector6d& u, double a) {
  Matrix6d by_u = Matrix6d::Zero(), by_p = Matrix6d::Zero();
  by_u.topRightCorner<3, 3>() = by_u.bottomLeftCorner<3, 3>() = cross_matrix(p.head<3>());
  by_u.bottomRightCorner<3, 3>() = cross_matrix(p.tail<3>());
  by_p.topLeftCorner<3, 3>() = by_p.bottomRightCorner<3, 3>() = -cross_matrix(u.tail<3>());
  by_p.bottomLeftCorner<3, 3>() = -cross_matrix(u.head<3>());
  return Matrix6d::Identity() - a * (by_u * S_inverse + by_p);
}

/// The mean momentum of (E2) with its velocity and a.
struct Mean {
  Vector6d p = Vector6d::Zero();
  Vector6d u = Vector6d::Zero();
  double a = 0;
};

/// Solves (E2) from the momentum p: by repeated substitution while that is quick, by Newton's
/// method where it is not. Nothing, should neither do.
std::optional<Mean> solve_mean(const Matrix6d& S_inverse, const Vector6d& p, double time) {
  Mean mean{.p = p};
  std::optional<Eigen::PartialPivLU<Matrix6d>> newton;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostDriftSolves; ++i) {
    mean.u = S_inverse * mean.p;
    const double speed = mean.u.tail<3>().norm();
    if (!(speed * time < kLargestSolvedTurn)) return std::nullopt;  // the tangent has a pole
    mean.a = half_step(speed, time);
    const Vector6d rest = p + mean.a * kirchhoff(mean.p, mean.u) - mean.p;
    const double size = rest.norm();
    if (size <= kDriftConverged * mean.p.norm()) return mean;
    if (size >= last && size <= kDriftRoundOff * mean.p.norm()) break;
    if (size > kSlowConvergence * last) newton.emplace(slope(S_inverse, mean.p, mean.u, mean.a));
    last = size;
    mean.p += newton ? newton->solve(rest) : rest;
  }
  mean.u = S_inverse * mean.p;
  if (!keeps_energy(S_inverse, p, 2 * mean.p - p)) return std::nullopt;
  return mean;
}

/// A quaternion of unit length but for round-off, made so by a step of Newton's method.
Eigen::Quaterniond renormalized(const Eigen::Quaterniond& q) {
  return Eigen::Quaterniond((1.5 - q.squaredNorm() / 2) * q.coeffs());
}

/// One application of (E2) and (E3); where its equation is too stiff to be solved, in halves.
/// Should no half do, the body moves on as it does, which keeps the energy too.
void advance(const Matrix6d& S_inverse, Momentum& m, double time, int halvings) {
  std::optional<Mean> mean = solve_mean(S_inverse, m.p, time);
  if (!mean) {
    if (halvings > 0) {
      advance(S_inverse, m, time / 2, halvings - 1);
      return advance(S_inverse, m, time / 2, halvings - 1);
    }
    mean = {.p = m.p, .u = S_inverse * m.p};
  }
  m.x += m.R * displacement(mean->u, m.p.head<3>(), mean->p.head<3>(), mean->a, time);
  m.q = renormalized(m.q * exponential(time * mean->u.tail<3>()));
  m.R = m.q.toRotationMatrix();
  m.p = 2 * mean->p - m.p;
}

/// Euler's equations for the angular momentum L in B by (E2); returns ω̄.
Vector3d turn_by_midpoint(const Matrix3d& inertia, const Matrix3d& inverse, Vector3d& w,
                          double time) {
  const Vector3d L = inertia * w;
  Vector3d mean = L;
  for (int i = 0; i < kMostDriftSolves; ++i) {
    const Vector3d rate = inverse * mean;
    const Vector3d next = L + half_step(rate.norm(), time) * mean.cross(rate);
    const double change = (next - mean).squaredNorm();
    mean = next;
    if (change <= kDriftConverged * kDriftConverged * L.squaredNorm()) break;
  }
  w = inverse * (2 * mean - L);
  return inverse * mean;
}

/// (0, −v × P) in W.
Vector6d gyration(const Vector6d& u, const Vector6d& p) {
  return to_vector6(Vector3d::Zero(), -u.head<3>().cross(p.head<3>()));
}

/// A body some of whose degrees of freedom are held.
struct PartlyLockedBody {
  const Matrix6d& inertia_B;
  const DofMask& locked;

  Matrix6d inertia(const Eigen::Quaterniond& q) const {
    return rotate_tensor(q.toRotationMatrix(), inertia_B);
  }
};

/// How it moves, in W.
struct HeldMotion {
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  Vector6d u = Vector6d::Zero();  ///< Relative to the water.
};

/// One midpoint step of (E1a) by repeated substitution; nothing where that leads nowhere.
std::optional<HeldMotion> solve_held(const PartlyLockedBody& body, const HeldMotion& start,
                                     double time) {
  const Vector6d p0 = body.inertia(start.q) * start.u;
  HeldMotion end = start;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostDriftSolves; ++i) {
    const Vector6d mean = (start.u + end.u) / 2;
    end.q = (exponential(time * mean.tail<3>()) * start.q).normalized();
    const Matrix6d S = body.inertia(end.q);
    const Vector6d rest = p0 + time * gyration(mean, (p0 + S * end.u) / 2) - S * end.u;
    const Vector6d change = solve_free(S, rest, {.locked = body.locked});
    end.u += change;
    const double size = change.norm();
    if (size <= kDriftConverged * end.u.norm()) return end;
    if (size >= last && size <= kDriftRoundOff * end.u.norm()) return end;
    if (!std::isfinite(size)) break;
    last = size;
  }
  return std::nullopt;
}

/// The energy of the motion that is free, and that of what is held: (E3a).
struct HeldEnergy {
  double free = 0;
  double held = 0;
};

HeldEnergy held_energy(const PartlyLockedBody& body, const HeldMotion& motion) {
  Vector6d free = motion.u, held = motion.u;
  for (int i = 0; i < 6; ++i) (body.locked[static_cast<std::size_t>(i)] ? free : held)[i] = 0;
  const Matrix6d S = body.inertia(motion.q);
  return {.free = free.dot(S * free) / 2, .held = held.dot(S * held) / 2};
}

/// True if (E3a) is kept well enough.
bool keeps_energy(const PartlyLockedBody& body, const HeldMotion& before, const HeldMotion& after) {
  const HeldEnergy first = held_energy(body, before), last = held_energy(body, after);
  const double change = (last.free - last.held) - (first.free - first.held);
  // An energy beyond all numbers would be within any part of itself.
  return std::isfinite(change) &&
         std::abs(change) <= kLockedEnergyKept * std::max(first.free, last.free) +
                                 kDriftRoundOff * std::max(first.held, last.held);
}

/// A step of (E1a) and how far it goes relative to the water; in halves where one cannot be solved
/// or does not keep (E3a). Should no half do, the body goes on as it does without turning, which
/// does.
Vector3d advance_held(const PartlyLockedBody& body, HeldMotion& motion, double time, int halvings) {
  const std::optional<HeldMotion> end = solve_held(body, motion, time);
  if (!end || !keeps_energy(body, motion, *end)) {
    if (halvings == 0) return time * motion.u.head<3>();
    const Vector3d first = advance_held(body, motion, time / 2, halvings - 1);
    return first + advance_held(body, motion, time / 2, halvings - 1);
  }
  const Vector3d way = time * (motion.u + end->u).head<3>() / 2;
  motion = *end;
  return way;
}

}  // namespace

Eigen::Quaterniond exponential(const Vector3d& turn) {
  const double square = turn.squaredNorm() / 4;  // of half the turn
  double cosine = 0, sinc = 0;                   // sinc is that of half the turn, halved
  if (square < kShortTurn) {
    cosine = 1 - square / 2 * (1 - square / 12 * (1 - square / 30 * (1 - square / 56)));
    sinc = 0.5 - square / 12 * (1 - square / 20 * (1 - square / 42 * (1 - square / 72)));
  } else {
    const double half = std::sqrt(square);
    cosine = std::cos(half);
    sinc = std::sin(half) / (2 * half);
  }
  const Vector3d v = sinc * turn;
  return {cosine, v.x(), v.y(), v.z()};
}

Eigen::Quaterniond turned_by(const Vector3d& turn_W, const Eigen::Quaterniond& orientation) {
  return renormalized(exponential(turn_W) * orientation);
}

double turning_rate(const Matrix6d& S, const Vector6d& u) {
  const Vector3d P = (S * u).head<3>();
  const double fastest = std::max(u.head<3>().norm(), P.norm() / S.diagonal().head<3>().minCoeff());
  const double bent = P.cross(u.head<3>()).norm() > 1e-12 * P.norm() * u.head<3>().norm() ? 1 : 0;
  const double munk = bent * P.norm() * fastest / S.diagonal().tail<3>().minCoeff();
  return u.tail<3>().norm() + std::sqrt(munk);
}

hydro::BodyState drifted(const Matrix6d& inertia_B, const hydro::BodyState& state,
                         const Vector3d& current, double time) {
  Momentum m{.R = state.orientation.toRotationMatrix(), .q = state.orientation};
  const Vector6d u_B = rotate(m.R.transpose(), velocity(state, current));
  m.p = inertia_B * u_B;
  const Matrix6d S_inverse = hydro::Cholesky6(inertia_B).inverse();
  const int count = pieces(turning_rate(inertia_B, u_B), time);
  for (int i = 0; i < count; ++i) advance(S_inverse, m, time / count, kMostDriftHalvings);
  hydro::BodyState next = with_velocity(state, rotate(m.R, Vector6d(S_inverse * m.p)), current);
  next.position += m.x + time * current;
  next.orientation = m.q;
  return next;
}

hydro::BodyState drifted(const BodySpec& body, const hydro::BodyState& state, double time) {
  hydro::BodyState next = turned_freely(body.inertia_B, state, time);
  next.position += time * state.linear_velocity;
  return next;
}

hydro::BodyState turned_freely(const Matrix3d& inertia, const hydro::BodyState& state,
                               double time) {
  hydro::BodyState next = state;
  if (state.angular_velocity.isZero(0)) return next;
  const bool round =
      inertia.isDiagonal(0) && inertia(0, 0) == inertia(1, 1) && inertia(1, 1) == inertia(2, 2);
  if (round) {
    next.orientation = turned_by(time * state.angular_velocity, state.orientation);
    return next;
  }
  const Matrix3d inverse = inertia.inverse();
  Vector3d w_B = state.orientation.conjugate() * state.angular_velocity;
  const int count = pieces(w_B.norm(), time);
  for (int i = 0; i < count; ++i) {
    const Vector3d mean = turn_by_midpoint(inertia, inverse, w_B, time / count);
    next.orientation = renormalized(next.orientation * exponential(time / count * mean));
  }
  next.angular_velocity = next.orientation * w_B;
  return next;
}

hydro::BodyState drifted(const Matrix6d& inertia_B, const DofMask& locked,
                         const hydro::BodyState& state, const Vector3d& current, double time) {
  hydro::BodyState next = state;
  if (state.angular_velocity.isZero(0) && locked[3] && locked[4] && locked[5]) {
    next.position += time * state.linear_velocity;
    return next;
  }
  const PartlyLockedBody body{.inertia_B = inertia_B, .locked = locked};
  HeldMotion motion{.q = state.orientation, .u = velocity(state, current)};
  // What is held can make the body turn ever faster: each piece is chosen by the motion it starts
  // with.
  const double shortest = time / kMostDriftParts;
  double rest = time;
  while (rest > 0) {
    const Matrix3d R_BW = motion.q.conjugate().toRotationMatrix();
    const int count = pieces(turning_rate(inertia_B, rotate(R_BW, motion.u)), rest);
    const double piece = count == 1 ? rest : std::min(rest, std::max(shortest, rest / count));
    next.position += advance_held(body, motion, piece, kMostDriftHalvings) + piece * current;
    rest = count == 1 ? 0 : rest - piece;
  }
  next.orientation = motion.q;
  return with_velocity(next, motion.u, current);
}

}  // namespace engine
