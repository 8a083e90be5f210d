#include "engine/kick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/added_inertia.h"
#include "engine/wetness.h"
#include "hydro/decompositions.h"
#include "hydro/loads/load_jacobian.h"

namespace engine {
namespace {

constexpr int kMostNewtonSteps = 30;
// Of the change of velocity. Newton's method converges quadratically: the error is the square.
constexpr double kNewtonTolerance = 1e-3;
constexpr double kNewtonFloor = 1e-12;  // of the velocity: in balance a change is round-off
// What a change may miss the foretold one by, as a part of the larger.
constexpr double kForetold = 0.3;
// Of the pose in equation (1), of the body's radius: oscillations that a piece resolves take less.
constexpr double kLargestShift = 0.02;

/// Everything about one kick that its parts share.
struct Setting {
  Body& body;
  const Surroundings& around;
  const Middle& middle;
  const hydro::BodyState& state;  ///< Halfway.
  const Eigen::Matrix3d& R_WB;
  Vector6d u;  ///< Relative to the water, W, without the loads.
  Freedom freedom;
  double time;
  double step;

  hydro::BodyState at(const Vector6d& relative) const {
    return with_velocity(state, relative, around.current());
  }
  Vector6d loads(const Vector6d& relative) const {
    return stacked(find_loads(body, around, at(relative), time));
  }
  /// F of equation (1). A change that would take the pose far is of no use for that.
  Vector6d loads_halfway(const Vector6d& change) const {
    const Vector6d shift = step / 12 * change;
    const double length = shift.head<3>().norm() + body.radius * shift.tail<3>().norm();
    hydro::BodyState halfway = at(u + change / 2);
    if (length <= kLargestShift * body.radius) halfway = displaced(body, halfway, shift);
    const Vector6d F = stacked(find_loads(body, around, halfway, time));
    return body.guide ? brought_back(F, halfway) : F;
  }
  /// Loads of another pose on the guide as those of this one that do the same to its rates.
  Vector6d brought_back(const Vector6d& F, const hydro::BodyState& from) const {
    const Ways more = ways(*body.guide, from) - *freedom.ways;  // none on a slider
    Vector6d result = F;
    for (Eigen::Index i = 0; i < more.cols(); ++i)
      result.tail<3>() += more.col(i).dot(F) * freedom.ways->col(i).tail<3>();
    return result;
  }
  Matrix6d S() const { return inertia_W(body, middle); }
  double least_mass() const {
    return body.adds ? S().diagonal().head<3>().minCoeff() : body.spec->mass;
  }
  /// v·S v
  double square(const Vector6d& v) const {
    if (body.adds) return v.dot(S() * v);
    const Eigen::Vector3d spin_B = R_WB.transpose() * v.tail<3>();
    return body.spec->mass * v.head<3>().squaredNorm() + spin_B.dot(body.spec->inertia_B * spin_B);
  }
  Vector6d solve(const Matrix6d& matrix, const Vector6d& rhs) const {
    return solve_free(matrix, rhs, freedom);
  }
  /// S⁻¹ rhs in the free degrees of freedom.
  Vector6d accelerated(const Vector6d& rhs) const {
    if (body.adds || body.locked || body.guide) return solve(S(), rhs);
    return stacked(rhs.head<3>() / body.spec->mass,
                   R_WB * (body.inverse_inertia_B * (R_WB.transpose() * rhs.tail<3>())));
  }
};

Setting make_setting(Body& body, const Surroundings& around, const Middle& middle, double time,
                     double step) {
  return {.body = body,
          .around = around,
          .middle = middle,
          .state = middle.motion->state,
          .R_WB = middle.R_WB,
          .u = middle.mean(),
          .freedom = freedom(body, middle.motion->state),
          .time = time,
          .step = step};
}

/// ζ along the motion u from the drag of the last evaluation, and in the measure of the energy how
/// much larger the motion `after` is.
double drag_stiffness(const Setting& s, const Vector6d& u, const Vector6d& after) {
  const hydro::Loads& water = s.body.loads.water;
  const Vector6d D = stacked(water.pressure_drag + water.viscous_drag);
  const double power = -D.dot(u);
  if (!(power > 0)) return 0;
  const double growth = std::sqrt(std::max(1.0, s.square(after) / s.square(u)));
  return 2 * growth * s.step * D.dot(s.accelerated(D)) / power;
}

/// Change of the buoyancy with the height, −∂F_z/∂z [N/m].
double heave_stiffness(const Setting& s, double height) {
  hydro::Coefficients coefficients{.pressure_drag = {0, 0}, .lift = 0};
  coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  const auto buoyancy = [&](double rise) {
    hydro::BodyState state = s.state;
    state.position.z() += rise;
    return hydro::compute_loads(*s.body.hull, state, *s.around.sea, s.time, coefficients)
        .buoyancy.force.z();
  };
  const double rise = 1e-3 * height;
  return (buoyancy(-rise) - buoyancy(rise)) / (2 * rise);
}

/// A bound of (h ω)² for heave, roll and pitch: no radius of gyration of a waterplane is more than
/// √3 times the body's. Where it may matter the waterplane is that of the loads.
double waterplane_stiffness(const Setting& s) {
  const Surroundings& around = s.around;
  if (!s.body.spec->coefficients.buoyancy) return 0;
  // No waterplane is larger than the widest section of the box.
  const Eigen::Vector3d size = s.body.box_B.sizes();
  const double area = size.prod() / size.minCoeff() * std::sqrt(3.0);
  const double factor = 3 * s.step * s.step / s.least_mass();
  const double bound = factor * around.sea->density * around.sea->gravity * area;
  if (!(bound > kStiffWaterplane)) return bound;
  const auto [low, reach] = extent_of(s.body.box_B, s.state);
  if (low >= around.highest || low + reach <= around.lowest) return 0;
  return factor * heave_stiffness(s, reach);
}

/// θ of equation (2).
double theta(double stiffness) {
  if (stiffness < 1e-3) return 0.5 + stiffness / 12;
  return std::min(1.0, std::max(0.5, 1 / -std::expm1(-stiffness) - 1 / stiffness));
}

/// ζ: the largest eigenvalue of −h J in the metric of S.
double largest_stiffness(const Setting& s, const Matrix6d& J) {
  return std::max(0.0, -s.step * hydro::eigenvalues(hydro::Cholesky6(s.S()).relative(J))[0]);
}

hydro::LoadJacobian jacobian(const Setting& s, const Vector6d& relative) {
  return hydro::load_jacobian(*s.body.hull, s.at(relative), *s.around.sea, s.time,
                              s.body.spec->coefficients);
}

/// S − ¼h²K, or S where K is no stiffness: where waves are too steep to be followed by panels, more
/// water may seem to lie on top of a body than below it.
Matrix6d with_waterplane(const Setting& s, const Matrix6d& K) {
  const Matrix6d less = s.step * s.step / 4 * K;
  const Matrix6d S = s.S();
  return hydro::Cholesky6(S / 2 - less).positive_definite() ? Matrix6d(S - less) : S;
}

struct Solution {
  Vector6d change;  ///< Or where it was nearest, which the first one, linearised, is at least.
  bool converged = false;
};

/// Equation (2) by Newton's method from rest: an explicit change can be off by orders of magnitude.
/// The Jacobian is that of the drag, as lift takes no energy and is weak as a rule.
/// @param with_lift   If false, lift is left out.
Solution implicit_change(const Setting& s, bool with_lift) {
  Vector6d change = Vector6d::Zero(), nearest = change;
  const double floor = kNewtonFloor * kNewtonFloor * s.square(s.u);
  double part = 0.5, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostNewtonSteps; ++i) {
    Vector6d at = s.u + part * change;
    const hydro::LoadJacobian J = jacobian(s, at);
    part = std::max(part, theta(largest_stiffness(s, J.drag)));
    at = s.u + part * change;
    const Matrix6d S = with_waterplane(s, J.waterplane);
    Vector6d F = s.loads(at);
    if (!with_lift) F -= stacked(s.body.loads.water.lift);
    const Vector6d correction = s.solve(S - s.step * part * J.drag, s.step * F - S * change);
    change += correction;
    const double missed = correction.dot(S * correction);
    const double size = change.dot(S * change);
    if (missed <= kNewtonTolerance * kNewtonTolerance * size + floor)
      return {.change = change, .converged = true};
    if (missed < least) nearest = change;
    least = std::min(least, missed);
  }
  return {.change = nearest};
}

/// Equation (2). Lift that would turn the motion farther in the step than can be followed is left
/// out: from iterations that do not converge with it a body could take any speed.
Vector6d implicit_change(const Setting& s) {
  const Solution whole = implicit_change(s, true);
  return whole.converged ? whole.change : implicit_change(s, false).change;
}

/// Δu of a body that the water leaves alone.
Vector6d dry_change(Body& body, const Surroundings& around, const hydro::BodyState& state,
                    double time, double step) {
  const hydro::Wrench load = find_loads(body, around, state, time);
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();
  if (!load.moment.isZero(0)) {
    const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
    turning = step * (R_WB * (body.inverse_inertia_B * (R_WB.transpose() * load.moment)));
  }
  return stacked(step / body.spec->mass * load.force, turning);
}

/// Equation (1) with Δu_0 = `expected`.
Kick kick_by(const Setting& s, const Vector6d& expected) {
  Kick kick{.load = s.loads_halfway(expected), .at = s.u + expected / 2};
  kick.change = s.accelerated(s.step * kick.load);
  return kick;
}

/// Equation (1). A change that was not foretold, as when a load sets in, is what the loads are
/// taken with once more.
Kick explicit_kick(const Setting& s, const Motion& middle) {
  if (!middle.kicks.empty()) {
    const Vector6d expected = s.step * turned(s.R_WB, middle.kicks.expected(s.step / 2));
    const Kick kick = kick_by(s, expected);
    const double radius = s.body.radius;
    const double missed = size(Vector6d(kick.change - expected), radius);
    const double last = s.step * middle.kicks.largest();
    if (missed <= kForetold * std::max(size(kick.change, radius), last)) return kick;
  }
  Kick first{.load = s.loads(s.u)};
  first.change = s.accelerated(s.step * first.load);
  first.sudden = true;
  if (s.body.loads.water.wetted_area == 0 && !s.body.guide && !s.body.pull) return first;
  Kick kick = kick_by(s, first.change);
  kick.sudden = true;
  // From the velocity of the start to that halfway; poses were the same.
  kick.slope = (kick.change - first.change) / (s.step * s.step / 2);
  return kick;
}

}  // namespace

Middle make_middle(const Body& body, const Surroundings& around, const Motion& motion,
                   const Matrix6d& added_B, const Freedom& freedom) {
  const Vector6d u = velocity(motion.state, around.current());
  const Eigen::Matrix3d R_WB = motion.state.orientation.toRotationMatrix();
  Middle middle{.motion = &motion, .R_WB = R_WB, .inertia = {}, .before = u, .after = u};
  if (!body.adds) return middle;
  middle.inertia = inertia_W(body, motion, R_WB);
  if (added_B == motion.added()) return middle;
  const Matrix6d change = turned_matrix(R_WB, added_B - motion.added());
  const InertiaChange result = inertia_change(*middle.inertia, change, freedom, u);
  middle.inertia = result.inertia;
  middle.after = result.velocity;
  return middle;
}

Matrix6d inertia_W(const Body& body, const Middle& middle) {
  return middle.inertia ? *middle.inertia : inertia_W(body, *middle.motion, middle.R_WB);
}

Kick free_kick_again(Body& body, const Surroundings& around, const Middle& middle, const Kick& last,
                     double time, double step) {
  if (last.implicit) return free_kick(body, around, middle, time, step);
  Kick kick = last;
  kick.change =
      solve_free(inertia_W(body, middle), step * last.load, freedom(body, middle.motion->state));
  return kick;
}

Kick free_kick(Body& body, const Surroundings& around, const Middle& middle, double time,
               double step) {
  if (!body.wet && !body.adds && !body.locked && !body.guide && !body.pull)
    return {.change = dry_change(body, around, middle.motion->state, time, step)};
  const Setting s = make_setting(body, around, middle, time, step);
  Kick kick = explicit_kick(s, *middle.motion);
  if (!body.wet || body.loads.water.wetted_area == 0) return kick;
  kick.implicit = drag_stiffness(s, kick.at, s.u + kick.change) > kStiffDrag ||
                  waterplane_stiffness(s) > kStiffWaterplane;
  if (kick.implicit) kick.change = implicit_change(s);
  return kick;
}

EffectiveLoad effective_load(Body& body, const Surroundings& around, const Middle& middle,
                             const Vector6d& expected, double time, double step) {
  const Setting s = make_setting(body, around, middle, time, step);
  Vector6d at = s.u + expected / 2;
  EffectiveLoad result{.inertia = s.S(), .load = s.loads(at)};
  if (!body.wet || body.loads.water.wetted_area == 0) return result;
  const Vector6d after = s.u + expected + step * s.accelerated(result.load);
  result.implicit =
      drag_stiffness(s, at, after) > kStiffDrag || waterplane_stiffness(s) > kStiffWaterplane;
  if (!result.implicit) return result;
  hydro::LoadJacobian J = jacobian(s, at);
  result.theta = theta(largest_stiffness(s, J.drag));
  at = s.u + result.theta * expected;
  J = jacobian(s, at);
  result.inertia = with_waterplane(s, J.waterplane) - step * result.theta * J.drag;
  result.load = s.loads(at) - result.theta * J.drag * expected;
  return result;
}

}  // namespace engine
