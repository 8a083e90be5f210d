#include "app/logs/interpolation.h"

#include <cmath>

namespace app {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using hydro::BodyState;

/// Evaluates Hermite's cubic at the fraction s of an interval h.
Vector3d hermite(const Vector3d& x0, const Vector3d& v0, const Vector3d& x1, const Vector3d& v1,
                 double h, double s) {
  const double t = 1 - s;
  return t * t * (1 + 2 * s) * x0 + s * s * (1 + 2 * t) * x1 + h * s * t * (t * v0 - s * v1);
}

/// Returns the shorter rotation vector of an attitude.
Vector3d rotation_vector(Quaterniond q) {
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  const double angle = 2 * std::atan2(sine, q.w());
  return sine > 0 ? Vector3d(angle / sine * q.vec()) : Vector3d(2 * q.vec());
}

Quaterniond attitude(const Vector3d& turn) {
  const double angle = turn.norm();
  if (angle == 0) return Quaterniond::Identity();
  return Quaterniond(Eigen::AngleAxisd(angle, turn / angle));
}

}  // namespace

// The rate of a rotation vector θ in the body's axes is
// ω + θ × ω/2 + θ × (θ × ω)/12 − …
BodyState between(const BodyState& a, const BodyState& b, double h, double s) {
  const Vector3d turn = rotation_vector(a.orientation.conjugate() * b.orientation);
  const Vector3d w0 = a.orientation.conjugate() * a.angular_velocity;
  const Vector3d w1 = b.orientation.conjugate() * b.angular_velocity;
  const Vector3d rate = w1 + turn.cross(w1) / 2 + turn.cross(turn.cross(w1)) / 12;
  return {.position = hermite(a.position, a.linear_velocity, b.position, b.linear_velocity, h, s),
          .orientation = a.orientation * attitude(hermite(Vector3d::Zero(), w0, turn, rate, h, s)),
          .linear_velocity = (1 - s) * a.linear_velocity + s * b.linear_velocity,
          .angular_velocity = (1 - s) * a.angular_velocity + s * b.angular_velocity};
}

}  // namespace app
