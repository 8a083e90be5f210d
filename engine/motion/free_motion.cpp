#include "engine/motion/free_motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/base/constants.h"
#include "engine/motion/added_inertia.h"
#include "engine/motion/locks.h"
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

/// Number of equal parts in which a motion at this rate [rad/s] turns by kLargestTurn at most.
int count_parts(double rate, double time) {
  return static_cast<int>(
      std::clamp(std::ceil(rate * time / kLargestTurn), 1.0, 1.0 * kMostDriftParts));
}

/// Momentum in B with that of rotors, displacement in W and orientation.
struct DriftState {
  Vector6d p;
  Vector3d x = Vector3d::Zero();
  Eigen::Quaterniond q;
};

/// S⁻¹ and H of (E1), in B.
struct Inertia {
  Matrix6d inverse;
  Vector6d rotors;

  Vector6d velocity(const Vector6d& p) const { return inverse * (p - rotors); }
};

/// Displacement of (E3), in the body axes of the start.
Vector3d displacement(const Vector6d& u, const Vector3d& P0, const Vector3d& P, double a,
                      double time) {
  const Vector3d v = u.head<3>(), w = u.tail<3>();
  const double b = 2 * a / (1 + a * a * w.squaredNorm());
  const double P2 = P.squaredNorm();
  const Vector3d straight = P2 > 0 ? Vector3d(v.dot(P) / P2 * P0) : v;
  return b * (v + a * w.cross(v)) + (time - b) * straight;
}

/// Derivative of p − p₀ − a (P × ω, L × ω + P × v) with respect to p, with u = S⁻¹ p and constant
/// a.
Matrix6d slope(const Matrix6d& S_inverse, const Vector6d& p, const Vector6d& u, double a) {
  Matrix6d by_u = Matrix6d::Zero(), by_p = Matrix6d::Zero();
  by_u.topRightCorner<3, 3>() = by_u.bottomLeftCorner<3, 3>() = cross_matrix(p.head<3>());
  by_u.bottomRightCorner<3, 3>() = cross_matrix(p.tail<3>());
  by_p.topLeftCorner<3, 3>() = by_p.bottomRightCorner<3, 3>() = -cross_matrix(u.tail<3>());
  by_p.bottomLeftCorner<3, 3>() = -cross_matrix(u.head<3>());
  return Matrix6d::Identity() - a * (by_u * S_inverse + by_p);
}

/// p̄, ū and a of (E2).
struct Mean {
  Vector6d p = Vector6d::Zero();
  Vector6d u = Vector6d::Zero();
  double a = 0;
};

/// Solves (E2) from the momentum p by repeated substitution, or by Newton's method where that is
/// slow. Returns nothing if neither converges.
std::optional<Mean> solve_mean(const Inertia& S, const Vector6d& p, double time) {
  Mean mean{.p = p};
  std::optional<Eigen::PartialPivLU<Matrix6d>> newton;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostDriftSolves; ++i) {
    mean.u = S.velocity(mean.p);
    const double speed = mean.u.tail<3>().norm();
    if (!(speed * time < kLargestSolvedTurn)) return std::nullopt;  // the tangent has a pole
    mean.a = half_step(speed, time);
    const Vector6d rest = p + mean.a * kirchhoff(mean.p, mean.u) - mean.p;
    const double size = rest.norm();
    if (size <= kDriftConverged * mean.p.norm()) return mean;
    if (size >= last && size <= kDriftRoundOff * mean.p.norm()) break;
    if (size > kSlowConvergence * last) newton.emplace(slope(S.inverse, mean.p, mean.u, mean.a));
    last = size;
    mean.p += newton ? newton->solve(rest) : rest;
  }
  mean.u = S.velocity(mean.p);
  const Vector6d own = p - S.rotors, end = 2 * mean.p - p - S.rotors;
  const double before = own.dot(S.inverse * own), after = end.dot(S.inverse * end);
  // An exact solution keeps the energy.
  if (!(std::abs(after - before) <= kDriftEnergyKept * before)) return std::nullopt;
  return mean;
}

/// Takes round-off from the length of a unit quaternion, by a step of Newton's method.
Eigen::Quaterniond renormalized(const Eigen::Quaterniond& q) {
  return Eigen::Quaterniond((1.5 - q.squaredNorm() / 2) * q.coeffs());
}

/// Applies (E2) and (E3), in halves where (E2) is too stiff to be solved. A half that is still too
/// stiff keeps its velocity, and so its energy.
void advance(const Inertia& S, DriftState& m, double time, int halvings) {
  std::optional<Mean> mean = solve_mean(S, m.p, time);
  if (!mean) {
    if (halvings > 0) {
      advance(S, m, time / 2, halvings - 1);
      return advance(S, m, time / 2, halvings - 1);
    }
    mean = {.p = m.p, .u = S.velocity(m.p)};
  }
  m.x += m.q.toRotationMatrix() *
         displacement(mean->u, m.p.head<3>(), mean->p.head<3>(), mean->a, time);
  m.q = renormalized(m.q * exponential(time * mean->u.tail<3>()));
  m.p = 2 * mean->p - m.p;
}

/// Advances ω in B and the orientation by Euler's equations, with (E2) solved by repeated
/// substitution. It converges for a body by itself. With added mass, one moment of inertia may be
/// thousands of times another, and where it does not, (E2) is solved as that of a whole body.
void turn_by_midpoint(const Matrix3d& inertia, const Matrix3d& inverse, const Vector3d& rotors,
                      Vector3d& w, Eigen::Quaterniond& q, double time) {
  const Vector3d L = inertia * w + rotors;
  Vector3d mean = L;
  double change = 0;
  for (int i = 0; i < kMostDriftSolves; ++i) {
    const Vector3d rate = inverse * (mean - rotors);
    const Vector3d next = L + half_step(rate.norm(), time) * mean.cross(rate);
    change = (next - mean).squaredNorm();
    mean = next;
    if (change <= kDriftConverged * kDriftConverged * L.squaredNorm()) break;
  }
  if (change <= kDriftRoundOff * kDriftRoundOff * L.squaredNorm()) {
    w = inverse * (2 * mean - L - rotors);
    q = renormalized(q * exponential(time * (inverse * (mean - rotors))));
    return;
  }
  Inertia S{.inverse = Matrix6d::Identity(), .rotors = to_vector6(Vector3d::Zero(), rotors)};
  S.inverse.bottomRightCorner<3, 3>() = inverse;
  DriftState m{.p = to_vector6(Vector3d::Zero(), L), .q = q};
  advance(S, m, time, kMostDriftHalvings);
  w = inverse * (m.p.tail<3>() - rotors);
  q = m.q;
}

/// (0, −v × P) in W.
Vector6d gyration(const Vector6d& u, const Vector6d& p) {
  return to_vector6(Vector3d::Zero(), -u.head<3>().cross(p.head<3>()));
}

/// The motion of a body with locks: its velocity is relative to the water, in W.
struct LockedMotion {
  Eigen::Quaterniond q;
  Vector6d u;
};

/// Its inertia and the momentum of its rotors, in B, and its locks.
struct PartlyLockedBody {
  const Matrix6d& inertia_B;
  const DofMask& locked;
  const Vector3d& rotors_B;

  Vector6d momentum(const Matrix6d& S, const LockedMotion& motion) const {
    return S * motion.u + to_vector6(Vector3d::Zero(), motion.q * rotors_B);
  }
  Matrix6d inertia_W(const Eigen::Quaterniond& q) const {
    return rotate_tensor(q.toRotationMatrix(), inertia_B);
  }
};

/// Solves one midpoint step of (E1a) by repeated substitution; returns nothing if that diverges.
std::optional<LockedMotion> solve_locked(const PartlyLockedBody& body, const LockedMotion& start,
                                         double time) {
  const Vector6d p0 = body.momentum(body.inertia_W(start.q), start);
  LockedMotion end = start;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostDriftSolves; ++i) {
    const Vector6d mean = (start.u + end.u) / 2;
    end.q = (exponential(time * mean.tail<3>()) * start.q).normalized();
    const Matrix6d S = body.inertia_W(end.q);
    const Vector6d p1 = body.momentum(S, end);
    const Vector6d rest = p0 + time * gyration(mean, (p0 + p1) / 2) - p1;
    const Vector6d change = solve_free(S, rest, {.locked = body.locked});
    end.u += change;
    const double size = change.norm(), speed = end.u.norm();
    if (size <= kDriftConverged * speed || (size >= last && size <= kDriftRoundOff * speed))
      return end;
    if (!std::isfinite(size)) break;
    last = size;
  }
  return std::nullopt;
}

/// True if (E3a) has changed by little.
bool keeps_energy(const PartlyLockedBody& body, const LockedMotion& before,
                  const LockedMotion& after) {
  const auto square = [&](const LockedMotion& motion, bool of_locked) {
    Vector6d u = motion.u;
    for (int i = 0; i < 6; ++i)
      if (body.locked[i] != of_locked) u[i] = 0;
    return u.dot(body.inertia_W(motion.q) * u) / 2;
  };
  const double free0 = square(before, false), locked0 = square(before, true);
  const double free1 = square(after, false), locked1 = square(after, true);
  const double change = (free1 - locked1) - (free0 - locked0);
  // An infinite energy would be within any part of itself.
  return std::isfinite(change) &&
         std::abs(change) <= kLockedEnergyKept * std::max(free0, free1) +
                                 kDriftRoundOff * std::max(locked0, locked1);
}

/// Takes a step of (E1a), in halves where it cannot be solved or does not keep (E3a). A half that
/// still does not keeps its velocity and orientation, and so (E3a).
/// @return the displacement relative to the water.
Vector3d advance_locked(const PartlyLockedBody& body, LockedMotion& motion, double time,
                        int halvings) {
  const std::optional<LockedMotion> end = solve_locked(body, motion, time);
  if (!end || !keeps_energy(body, motion, *end)) {
    if (halvings == 0) return time * motion.u.head<3>();
    const Vector3d first = advance_locked(body, motion, time / 2, halvings - 1);
    return first + advance_locked(body, motion, time / 2, halvings - 1);
  }
  const Vector3d displacement = time * (motion.u + end->u).head<3>() / 2;
  motion = *end;
  return displacement;
}

}  // namespace

Eigen::Quaterniond exponential(const Vector3d& turn) {
  const double square = turn.squaredNorm() / 4;  // of half the turn
  double cosine = 0, sinc = 0;                   // sin(|turn|/2) / |turn|
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

Eigen::Quaterniond rotated(const Eigen::Quaterniond& orientation, const Vector3d& turn_W) {
  return renormalized(exponential(turn_W) * orientation);
}

Vector6d kirchhoff(const Vector6d& p, const Vector6d& u) {
  const Vector3d P = p.head<3>(), L = p.tail<3>(), v = u.head<3>(), w = u.tail<3>();
  return to_vector6(P.cross(w), L.cross(w) + P.cross(v));
}

double turning_rate(const Matrix6d& S, const Vector6d& u, const Vector3d& rotors) {
  const Vector3d P = (S * u).head<3>();
  const double fastest = std::max(u.head<3>().norm(), P.norm() / S.diagonal().head<3>().minCoeff());
  const double bent = P.cross(u.head<3>()).norm() > 1e-12 * P.norm() * u.head<3>().norm() ? 1 : 0;
  const double munk = bent * P.norm() * fastest / S.diagonal().tail<3>().minCoeff();
  return u.tail<3>().norm() + std::sqrt(munk) + rotors.norm() / S.diagonal().tail<3>().minCoeff();
}

hydro::BodyState drifted(const Matrix6d& inertia_B, const hydro::BodyState& state,
                         const Vector3d& current, double time, const Vector3d& rotors_B) {
  assert(hydro::is_symmetric(inertia_B) && is_unit(state.orientation) && !(time < 0));
  const Matrix3d R_WB = state.orientation.toRotationMatrix();
  const Vector6d u_B = rotate(R_WB.transpose(), velocity(state, current));
  const hydro::Cholesky6 factor(inertia_B);
  assert(factor.positive_definite());
  const Inertia S{.inverse = factor.inverse(), .rotors = to_vector6(Vector3d::Zero(), rotors_B)};
  DriftState m{.p = inertia_B * u_B + S.rotors, .q = state.orientation};
  const int count = count_parts(turning_rate(inertia_B, u_B, rotors_B), time);
  for (int i = 0; i < count; ++i) advance(S, m, time / count, kMostDriftHalvings);
  hydro::BodyState next =
      with_velocity(state, rotate(m.q.toRotationMatrix(), S.velocity(m.p)), current);
  next.position += m.x + time * current;
  next.orientation = m.q;
  return next;
}

hydro::BodyState drifted(const BodySpec& body, const hydro::BodyState& state, double time,
                         const Vector3d& rotors_B) {
  hydro::BodyState next = rotated_freely(body.inertia_B, state, time, rotors_B);
  next.position += time * state.linear_velocity;
  return next;
}

hydro::BodyState rotated_freely(const Matrix3d& inertia, const hydro::BodyState& state, double time,
                                const Vector3d& rotors_B) {
  assert(hydro::is_symmetric(inertia) && is_unit(state.orientation));
  hydro::BodyState next = state;
  if (state.angular_velocity.isZero(0)) return next;
  const bool round = rotors_B.isZero(0) && inertia.isDiagonal(0) &&
                     inertia(0, 0) == inertia(1, 1) && inertia(1, 1) == inertia(2, 2);
  if (round) {
    next.orientation = rotated(state.orientation, time * state.angular_velocity);
    return next;
  }
  const Matrix3d inverse = inertia.inverse();
  Vector3d w_B = state.orientation.conjugate() * state.angular_velocity;
  const double nutation = rotors_B.norm() / inertia.diagonal().minCoeff();
  const int count = count_parts(w_B.norm() + nutation, time);
  for (int i = 0; i < count; ++i)
    turn_by_midpoint(inertia, inverse, rotors_B, w_B, next.orientation, time / count);
  next.angular_velocity = next.orientation * w_B;
  return next;
}

hydro::BodyState drifted(const Matrix6d& inertia_B, const DofMask& locked,
                         const hydro::BodyState& state, const Vector3d& current, double time,
                         const Vector3d& rotors_B) {
  hydro::BodyState next = state;
  if (state.angular_velocity.isZero(0) && locked[3] && locked[4] && locked[5]) {
    next.position += time * state.linear_velocity;
    return next;
  }
  const PartlyLockedBody body{.inertia_B = inertia_B, .locked = locked, .rotors_B = rotors_B};
  LockedMotion motion{.q = state.orientation, .u = velocity(state, current)};
  // Locks can make the body turn ever faster, so each part is chosen by the motion at its start.
  const double shortest = time / kMostDriftParts;
  double rest = time;
  while (rest > 0) {
    const Matrix3d R_BW = motion.q.conjugate().toRotationMatrix();
    const int count = count_parts(turning_rate(inertia_B, rotate(R_BW, motion.u), rotors_B), rest);
    const double duration = count == 1 ? rest : std::min(rest, std::max(shortest, rest / count));
    next.position +=
        advance_locked(body, motion, duration, kMostDriftHalvings) + duration * current;
    rest = count == 1 ? 0 : rest - duration;
  }
  next.orientation = motion.q;
  return with_velocity(next, motion.u, current);
}

}  // namespace engine
