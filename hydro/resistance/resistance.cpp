#include "hydro/resistance/resistance.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hydro {
namespace {

/// The slope of the parabola through a point and its neighbours, as far as it leaves the cubics on
/// both sides monotone, or at an extremum not far from it, and nowhere negative.
double limited_slope(double parabola, double before, double after, double least, double largest) {
  const double bound = 3 * std::min(std::abs(before), std::abs(after));
  if (before * after > 0) return std::clamp(parabola, -bound, bound);
  return std::clamp(std::clamp(parabola, -bound, bound), least, largest);
}

std::vector<double> limited_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> slopes(n, 0.0);
  const auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = secant(i - 1), after = secant(i);
    const double h = x[i] - x[i - 1], k = x[i + 1] - x[i];
    slopes[i] = limited_slope((k * before + h * after) / (h + k), before, after, -3 * y[i] / k,
                              3 * y[i] / h);
  }
  // The last one goes on as the square of the speed.
  slopes[n - 1] = std::min(2 * y[n - 1] / x[n - 1], 3 * std::max(0.0, secant(n - 2)));
  return slopes;
}

/// A point of the body.
struct MovingPoint {
  Eigen::Vector3d arm;       ///< From the centre of mass, in W [m].
  Eigen::Vector3d velocity;  ///< Through the water [m/s].

  Eigen::Vector3d along() const { return {velocity.x(), velocity.y(), 0}; }  ///< w [m/s]
};

MovingPoint moving_point(const Eigen::Vector3d& at_B, const BodyState& state,
                         const Eigen::Vector3d& water) {
  const Eigen::Vector3d arm = state.orientation * at_B;
  return {arm, state.linear_velocity + state.angular_velocity.cross(arm) - water};
}

/// s [-]
double share(const Resistance& resistance, double volume) {
  return std::clamp(2 * volume / resistance.volume, 0.0, 1.0);
}

}  // namespace

/// R = a + b t + c t² + d t³ over t from a point on.
struct ResistanceCurve::Cubic {
  double t, a, b, c, d;
};

ResistanceCurve::ResistanceCurve(const std::vector<double>& speeds,
                                 const std::vector<double>& forces)
    : speeds_{0}, forces_{0} {
  assert(!speeds.empty() && speeds.size() == forces.size() && speeds.front() > 0);
  speeds_.insert(speeds_.end(), speeds.begin(), speeds.end());
  forces_.insert(forces_.end(), forces.begin(), forces.end());
  assert(std::ranges::is_sorted(speeds_, std::ranges::less_equal()));
  assert(std::ranges::all_of(forces_, [](double force) { return force >= 0; }));
  slopes_ = limited_slopes(speeds_, forces_);
}

ResistanceCurve::Cubic ResistanceCurve::cubic_at(double speed) const {
  const auto above = std::ranges::upper_bound(speeds_, speed);
  const auto i = static_cast<std::size_t>(above - speeds_.begin()) - 1;
  if (above == speeds_.end()) {
    const double scale = forces_[i] / (speeds_[i] * speeds_[i]);
    return {.t = speed, .a = 0, .b = 0, .c = scale, .d = 0};
  }
  const double h = speeds_[i + 1] - speeds_[i];
  const double secant = (forces_[i + 1] - forces_[i]) / h;
  return {.t = speed - speeds_[i],
          .a = forces_[i],
          .b = slopes_[i],
          .c = (3 * secant - 2 * slopes_[i] - slopes_[i + 1]) / h,
          .d = (slopes_[i] + slopes_[i + 1] - 2 * secant) / (h * h)};
}

double ResistanceCurve::at(double speed) const {
  const Cubic p = cubic_at(speed);
  return p.a + p.t * (p.b + p.t * (p.c + p.t * p.d));
}

double ResistanceCurve::slope(double speed) const {
  const Cubic p = cubic_at(speed);
  return p.b + p.t * (2 * p.c + p.t * 3 * p.d);
}

Wrench resistance_load(const Resistance& resistance, const BodyState& state,
                       const Eigen::Vector3d& water, double volume) {
  const double s = share(resistance, volume);
  const MovingPoint p = moving_point(resistance.at_B, state, water);
  const double speed = p.along().norm();
  if (speed == 0 || s == 0) return {};
  const Eigen::Vector3d back = -s * resistance.curve.at(speed) / speed * p.along();
  const MovingPoint q = moving_point(resistance.suction_at_B, state, water);
  const Eigen::Vector3d w = q.along();
  const Eigen::Vector3d down =
      s * resistance.suction * (q.velocity.z() * w - w.squaredNorm() * Eigen::Vector3d::UnitZ());
  return {.force = back + down, .moment = p.arm.cross(back) + q.arm.cross(down)};
}

Matrix6d resistance_jacobian(const Resistance& resistance, const BodyState& state,
                             const Eigen::Vector3d& water, double volume) {
  const double s = share(resistance, volume);
  const MovingPoint p = moving_point(resistance.at_B, state, water);
  const double speed = p.along().norm();
  if (speed == 0 || s == 0) return Matrix6d::Zero();
  const Eigen::Vector3d along = p.along() / speed;
  const Eigen::Vector3d across(-along.y(), along.x(), 0);
  // The velocity of P is B u, of which only the horizontal part counts.
  Eigen::Matrix<double, 3, 6> B;
  B << Eigen::Matrix3d::Identity(), -cross_matrix(p.arm);
  const Vector6d b = B.transpose() * along, c = B.transpose() * across;
  const double rise = std::max(0.0, resistance.curve.slope(speed));
  return -s * (rise * b * b.transpose() + resistance.curve.at(speed) / speed * c * c.transpose());
}

}  // namespace hydro
