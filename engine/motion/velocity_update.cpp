#include "engine/motion/velocity_update.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "engine/base/constants.h"
#include "hydro/decompositions.h"
#include "hydro/loads/load_jacobian.h"

namespace engine {
namespace {

using hydro::Pieces;

/// Inputs that the parts of one update share.
struct UpdateContext {
  MovingBody& moving;
  const MidpointState& midpoint;
  double time;
  double h;
  const Body& body = moving.body;
  Vector6d u = midpoint.mean();  ///< Halfway without the loads, in W, relative to the water.
  Mobility mobility = engine::mobility(body, midpoint.motion->state);
  mutable std::optional<Matrix6d> known_S;  ///< Once it was asked for.
  mutable std::optional<hydro::Cholesky6> known_factor;

  const hydro::BodyState& state() const { return midpoint.motion->state; }
  const hydro::Loads& water() const { return moving.cache.loads.water; }
  hydro::BodyState at(const Vector6d& relative) const {
    return with_velocity(state(), relative, midpoint.motion->flow);
  }
  Vector6d loads(const Vector6d& relative) const {
    return to_vector6(find_loads(moving, *midpoint.motion, at(relative), time));
  }
  /// S, with what the memory of waves and stiff lines add.
  const Matrix6d& S() const {
    if (!known_S) {
      known_S = inertia_W(body, midpoint);
      if (midpoint.memory) *known_S += midpoint.memory->inertia;
      if (midpoint.rig_inertia) *known_S += *midpoint.rig_inertia;
    }
    return *known_S;
  }
  const hydro::Cholesky6& factor_of_S() const {
    if (!known_factor) known_factor.emplace(S());
    return *known_factor;
  }
  /// True if S is more than M.
  bool has_more_inertia() const { return body.has_added_mass || midpoint.rig_inertia; }
  /// The load F with that of the memory.
  Vector6d with_memory(const Vector6d& F) const {
    return midpoint.memory ? Vector6d(F + midpoint.memory->load + midpoint.memory->turning) : F;
  }
  /// Along the axes in which the body may move: S has 1 for a locked one.
  double least_mass() const {
    double least = std::numeric_limits<double>::infinity();
    if (has_more_inertia())
      for (int i = 0; i < 3; ++i)
        if (!body.spec->locked[i]) least = std::min(least, S()(i, i));
    return std::isfinite(least) ? least : body.spec->mass;
  }
  /// v·S v
  double square(const Vector6d& v) const {
    if (has_more_inertia()) return v.dot(S() * v);
    const Eigen::Vector3d spin_B = midpoint.R_WB.transpose() * v.tail<3>();
    return body.spec->mass * v.head<3>().squaredNorm() + spin_B.dot(body.spec->inertia_B * spin_B);
  }
  Vector6d solve(const Matrix6d& matrix, const Vector6d& rhs) const {
    return solve_free(matrix, rhs, mobility);
  }
  /// S⁻¹ rhs in the free velocities.
  Vector6d accelerated(const Vector6d& rhs) const {
    if (body.locked || body.reduced_joint) return solve(S(), rhs);
    assert(!has_more_inertia() || factor_of_S().positive_definite());
    if (has_more_inertia()) return factor_of_S().solve(rhs);
    const Eigen::Matrix3d& R_WB = midpoint.R_WB;
    return to_vector6(rhs.head<3>() / body.spec->mass,
                      R_WB * (body.inverse_inertia_B * (R_WB.transpose() * rhs.tail<3>())));
  }
};

/// Loads of another pose on the reduced joint as loads of this pose that do the same to its rates.
Vector6d brought_back(const UpdateContext& s, const Vector6d& F, const hydro::BodyState& from) {
  const Subspace& here = *s.mobility.subspace;
  const Subspace more = motion_subspace(*s.body.reduced_joint, from) - here;  // none on a slider
  Vector6d result = F;
  for (Eigen::Index i = 0; i < more.cols(); ++i)
    result.tail<3>() += more.col(i).dot(F) * here.col(i).tail<3>();
  return result;
}

/// (E5) with Δu₀ = `predicted`, whose pose stays where a shift would be large.
VelocityUpdate explicit_update(const UpdateContext& s, const Vector6d& predicted) {
  VelocityUpdate update{.at = s.u + predicted / 2};
  const Vector6d shift = s.h / 12 * predicted;
  const double length = shift.head<3>().norm() + s.body.radius * shift.tail<3>().norm();
  hydro::BodyState halfway = s.at(update.at);
  if (length <= kLargestShift * s.body.radius) halfway = displaced(s.body, halfway, shift);
  update.load = to_vector6(find_loads(s.moving, *s.midpoint.motion, halfway, s.time));
  if (s.body.reduced_joint) update.load = brought_back(s, update.load, halfway);
  update.change = s.accelerated(s.h * s.with_memory(update.load));
  return update;
}

/// ζ along the motion u from its drag D, and in the measure of the energy how much larger the
/// motion `after` is. Both are relative to the fluid that exerts the drag.
double drag_stiffness(const UpdateContext& s, const hydro::Wrench& drag, const Vector6d& u,
                      const Vector6d& after) {
  const Vector6d D = to_vector6(drag);
  const double power = -D.dot(u);
  if (!(power > 0)) return 0;
  const double growth = std::sqrt(std::max(1.0, s.square(after) / s.square(u)));
  return 2 * growth * s.h * D.dot(s.accelerated(D)) / power;
}

/// ζ of the drag of the last evaluation in water and air. The wind is that at the height of the
/// body's highest point.
double drag_stiffness(const UpdateContext& s, const Vector6d& u, const Vector6d& after) {
  const hydro::Loads& water = s.water();
  const double in_water = drag_stiffness(
      s, water.pressure_drag + water.viscous_drag + water.resistance + water.hull_lift, u, after);
  if (!s.body.feels_air) return in_water;
  const auto [low, height] = vertical_extent(s.body, s.state());
  const hydro::Wind& wind = s.body.environment.sea->air->wind;
  const double factor = wind.factor(std::max(0.0, low + height - s.body.environment.lowest));
  const Vector6d moving =
      to_vector6(s.midpoint.motion->flow - factor * wind.velocity, Eigen::Vector3d::Zero());
  return in_water + drag_stiffness(s, water.wind, u + moving, after + moving);
}

/// Change of the buoyancy with the height, −∂F_z/∂z [N/m].
double heave_stiffness(const UpdateContext& s, double height) {
  hydro::Coefficients coefficients{.pressure_drag = {0, 0}, .lift = 0};
  coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  const auto buoyancy = [&](double rise) {
    hydro::BodyState state = s.state();
    state.position.z() += rise;
    return sea_loads(s.body, *s.midpoint.motion, state, s.time, coefficients, {})
        .buoyancy.force.z();
  };
  const double rise = 1e-3 * height;
  return (buoyancy(-rise) - buoyancy(rise)) / (2 * rise);
}

/// A bound of (h ω)² for heave, roll and pitch: no radius of gyration of a waterplane is more than
/// √3 times the body's. Where it may matter the waterplane is that of the loads.
double waterplane_stiffness(const UpdateContext& s) {
  const Environment& environment = s.body.environment;
  if (!s.body.spec->coefficients.buoyancy) return 0;
  // No waterplane is larger than the widest section of the box.
  const Eigen::Vector3d size = s.body.box_B.sizes();
  const double area = size.prod() / size.minCoeff() * std::sqrt(3.0);
  const double factor = 3 * s.h * s.h / s.least_mass();
  const double bound = factor * environment.sea->density * environment.sea->gravity * area;
  if (!(bound > kStiffWaterplane)) return bound;
  const auto [low, reach] = vertical_extent(s.body, s.state());
  if (low >= environment.highest || low + reach <= environment.lowest) return 0;
  return factor * heave_stiffness(s, reach);
}

/// θ of (E6).
double theta(double stiffness) {
  if (stiffness < 1e-3) return 0.5 + stiffness / 12;
  return std::min(1.0, std::max(0.5, 1 / -std::expm1(-stiffness) - 1 / stiffness));
}

/// ζ: the largest eigenvalue of −h J in the metric of S.
double largest_stiffness(const UpdateContext& s, const Matrix6d& J) {
  return std::max(0.0, -s.h * hydro::eigenvalues(s.factor_of_S().relative(J))[0]);
}

hydro::LoadJacobian jacobian(const UpdateContext& s, const Vector6d& relative, Pieces pieces) {
  const hydro::BodyState at = s.at(relative);
  const double formed = formed_wake(s.body, *s.midpoint.motion, at);
  hydro::LoadJacobian J =
      hydro::load_jacobian(sea_hull(s.body, *s.midpoint.motion), at, *s.body.environment.sea,
                           s.time, s.body.spec->coefficients, pieces, formed);
  const bool sheds = formed < 1 && !s.body.wake->edges.none();
  if (!s.body.hull_lift && !s.body.spec->resistance && !sheds) return J;
  const hydro::HullWater water = water_about(s.body, at, s.time);
  if (s.body.hull_lift) J.drag += s.body.hull_lift->jacobian(at, water);
  if (sheds) J.drag += (1 - formed) * s.body.wake->edges.jacobian(at, water);
  if (s.body.spec->resistance)
    J.drag += hydro::resistance_jacobian(*s.body.spec->resistance, at, water.velocity,
                                         s.water().displaced_volume);
  return J;
}

/// S − ¼h²K, or S where K is no stiffness: where waves are too steep to be followed by panels, more
/// water may seem to lie on top of a body than below it.
Matrix6d with_waterplane(const UpdateContext& s, const Matrix6d& K) {
  const Matrix6d less = s.h * s.h / 4 * K;
  const Matrix6d& S = s.S();
  return hydro::Cholesky6(S / 2 - less).positive_definite() ? Matrix6d(S - less) : S;
}

struct Solution {
  Vector6d change;  ///< Or where it was nearest, which the first one, linearised, is at least.
  bool converged = false;
};

/// (E6) by Newton's method from rest: an explicit change can be off by orders of magnitude.
/// The Jacobian is that of the drag, as lift takes no energy and is weak as a rule.
/// @param with_lift   If false, lift is left out.
/// @param pieces      Pieces over which the Jacobian is summed.
Solution implicit_change(const UpdateContext& s, bool with_lift, Pieces pieces) {
  Vector6d change = Vector6d::Zero(), nearest = change;
  const double floor = kNewtonRoundOff * kNewtonRoundOff * s.square(s.u);
  double fraction = 0.5, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostNewtonSteps; ++i) {
    Vector6d at = s.u + fraction * change;
    const hydro::LoadJacobian J = jacobian(s, at, pieces);
    fraction = std::max(fraction, theta(largest_stiffness(s, J.drag)));
    at = s.u + fraction * change;
    const Matrix6d S = with_waterplane(s, J.waterplane);
    Vector6d F = s.with_memory(s.loads(at));
    if (!with_lift) F -= to_vector6(s.water().lift);
    const Vector6d correction = s.solve(S - s.h * fraction * J.drag, s.h * F - S * change);
    change += correction;
    const double missed = correction.dot(S * correction);
    const double size = change.dot(S * change);
    if (missed <= kNewtonTolerance * kNewtonTolerance * size + floor)
      return {.change = change, .converged = true};
    if (!(missed < kNewtonDivergence * kNewtonDivergence * least)) break;
    if (missed < least) nearest = change;
    least = std::min(least, missed);
  }
  return {.change = nearest};
}

/// (E6). Where its iterations do not converge, the Jacobian may have missed what is wet. Lift that
/// would turn the motion farther in the step than can be followed is left out: from iterations that
/// do not converge with it a body could take any speed.
Vector6d implicit_change(const UpdateContext& s) {
  const bool uneven = s.body.environment.uneven();
  Solution whole = implicit_change(s, true, Pieces::coarse);
  if (!whole.converged && uneven) whole = implicit_change(s, true, Pieces::fine);
  if (whole.converged) return whole.change;
  return implicit_change(s, false, uneven ? Pieces::fine : Pieces::coarse).change;
}

/// Δu of a body that nothing but applied loads and its weight acts on.
Vector6d dry_change(MovingBody& moving, const MidpointState& midpoint, double time, double h) {
  const hydro::Wrench load = find_loads(moving, *midpoint.motion, midpoint.motion->state, time);
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();
  if (!load.moment.isZero(0)) {
    const Eigen::Matrix3d& R_WB = midpoint.R_WB;
    turning = h * (R_WB * (moving.body.inverse_inertia_B * (R_WB.transpose() * load.moment)));
  }
  return to_vector6(h / moving.body.spec->mass * load.force, turning);
}

/// (E5) with loads found a second time where the first change was not predicted, as when a load
/// sets in.
VelocityUpdate repeated_update(const UpdateContext& s) {
  VelocityUpdate first{.load = s.loads(s.u)};
  first.change = s.accelerated(s.h * s.with_memory(first.load));
  first.unpredicted = true;
  const bool in_fluid = s.water().wetted_area > 0 || s.body.feels_air || s.moving.machines;
  if (!in_fluid && !s.body.reduced_joint && !s.moving.inputs.pull) return first;
  VelocityUpdate update = explicit_update(s, first.change);
  update.unpredicted = true;
  // Both have the same pose; their velocities are h/2 apart.
  update.slope = (update.change - first.change) / (s.h * s.h / 2);
  return update;
}

/// True if extrapolation has found the change well enough.
bool was_predicted(const UpdateContext& s, const Vector6d& predicted, const Vector6d& change) {
  const double radius = s.body.radius;
  const double missed = scaled_norm(Vector6d(change - predicted), radius);
  const double last = s.h * s.midpoint.motion->accelerations.largest();
  return missed <= kPredicted * std::max(scaled_norm(change, radius), last);
}

/// True if (E5) is not stable, or inaccurate, for the loads of the last evaluation.
bool is_stiff(const UpdateContext& s, const Vector6d& at, const Vector6d& after) {
  if (!s.body.wet || (s.water().wetted_area == 0 && !s.body.feels_air)) return false;
  return drag_stiffness(s, at, after) > kStiffDrag || waterplane_stiffness(s) > kStiffWaterplane;
}

}  // namespace

MidpointState make_midpoint(const Body& body, const Motion& motion, const Matrix6d& added_B,
                            const Mobility& mobility) {
  const Vector6d u = velocity(motion.state, motion.flow);
  const Eigen::Matrix3d R_WB = motion.state.orientation.toRotationMatrix();
  MidpointState midpoint{.motion = &motion, .R_WB = R_WB, .inertia = {}, .before = u, .after = u};
  if (!body.has_added_mass) return midpoint;
  midpoint.inertia = inertia_W(body, motion, R_WB);
  if (added_B == motion.added()) return midpoint;
  const Matrix6d change = rotate_tensor(R_WB, added_B - motion.added());
  const InertiaChange result = inertia_change(*midpoint.inertia, change, mobility, u);
  midpoint.inertia = result.inertia;
  midpoint.after = result.velocity;
  return midpoint;
}

Matrix6d inertia_W(const Body& body, const MidpointState& midpoint) {
  return midpoint.inertia ? *midpoint.inertia : inertia_W(body, *midpoint.motion, midpoint.R_WB);
}

VelocityUpdate free_update(MovingBody& moving, const MidpointState& midpoint, double time,
                           double h) {
  const Body& body = moving.body;
  if (body.held())
    return {.load = to_vector6(find_loads(moving, *midpoint.motion, midpoint.motion->state, time))};
  if (!body.wet && !body.has_added_mass && !body.locked && !body.reduced_joint &&
      !moving.inputs.pull && !midpoint.rig_inertia && !moving.machines)
    return {.change = dry_change(moving, midpoint, time, h)};
  const UpdateContext s{.moving = moving, .midpoint = midpoint, .time = time, .h = h};
  const AccelerationHistory& history = midpoint.motion->accelerations;
  const Vector6d predicted = h * rotate(midpoint.R_WB, history.expected(h / 2));
  VelocityUpdate update;
  if (!history.empty()) update = explicit_update(s, predicted);
  if (history.empty() || !was_predicted(s, predicted, update.change)) update = repeated_update(s);
  update.implicit = is_stiff(s, update.at, s.u + update.change);
  if (update.implicit) update.change = implicit_change(s);
  return update;
}

VelocityUpdate resolve_with_inertia(MovingBody& moving, const MidpointState& midpoint,
                                    const VelocityUpdate& last, double time, double h) {
  if (last.implicit) return free_update(moving, midpoint, time, h);
  const UpdateContext s{.moving = moving, .midpoint = midpoint, .time = time, .h = h};
  VelocityUpdate update = last;
  update.change = s.accelerated(h * s.with_memory(last.load));
  return update;
}

EffectiveLoad effective_load(MovingBody& moving, const MidpointState& midpoint,
                             const Vector6d& expected, double time, double h, Pieces pieces) {
  const UpdateContext s{.moving = moving, .midpoint = midpoint, .time = time, .h = h};
  Vector6d at = s.u + expected / 2;
  EffectiveLoad result{.inertia = s.S(), .load = s.with_memory(s.loads(at))};
  result.implicit = is_stiff(s, at, s.u + expected + h * s.accelerated(result.load));
  if (!result.implicit) return result;
  hydro::LoadJacobian J = jacobian(s, at, pieces);
  const double fraction = theta(largest_stiffness(s, J.drag));
  at = s.u + fraction * expected;
  J = jacobian(s, at, pieces);
  result.inertia = with_waterplane(s, J.waterplane) - h * fraction * J.drag;
  result.load = s.with_memory(s.loads(at)) - fraction * J.drag * expected;
  return result;
}

}  // namespace engine
