#include "engine/step/energy_limiter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/base/constants.h"
#include "engine/motion/energy.h"
#include "engine/step/substep_limit.h"
#include "hydro/statics/buoyancy_energy.h"

namespace engine {
namespace {

/// Scale of energies whose changes by kEnergyGain are not known [J]: 1e-9 of the weight of the body
/// and of the water in its place, times its size, is round-off. Under a height field the energy is
/// known to what its panels follow of the surface.
double least_energy_scale(const Body& body) {
  const double radius = body.radius, volume = std::pow(radius, 3);
  const hydro::Sea* sea = body.environment.sea;
  const double water = sea ? sea->density * volume : 0;
  const double unknown = sea ? hydro::energy_error_per_volume(*sea) * volume : 0;
  return 1e-9 * body.environment.gravity * (body.spec->mass + water) * radius +
         unknown / kEnergyGain;
}

/// True if lift, machines, lines that are loads, or applied loads may add to the energy: no earlier
/// energy then bounds it.
bool is_driven(const MovingBody& moving) {
  const hydro::Wrench& lines = moving.cache.loads.lines;
  return moving.body.spec->coefficients.lift != 0 || !moving.cache.loads.applied.empty() ||
         moving.machines || !lines.force.isZero(0) || !lines.moment.isZero(0);
}

/// Largest work that the last lift, machines, lines and applied loads may have done between two
/// states a time h [s] apart; 0 if they took energy [J].
double work_done(const MovingBody& moving, const hydro::BodyState& before,
                 const hydro::BodyState& after, double h) {
  const Eigen::Vector3d current = moving.body.current();
  hydro::Wrench load =
      moving.cache.loads.water.lift + moving.cache.loads.lines + moving.cache.loads.machines;
  for (const hydro::Wrench& applied : moving.cache.loads.applied) load += applied;
  const Vector6d F = to_vector6(load);
  return h * std::max({0.0, F.dot(velocity(before, current)), F.dot(velocity(after, current))});
}

/// True if the loads of a free substep were abrupt, or if one under joints is a large part of an
/// oscillation.
bool is_suspect(const SubstepBody& b, double h) {
  if (!b.end.constrained) return b.needs_energy_check;
  return !is_smooth(b.end.accelerations, h);
}

}  // namespace

void EnergyRange::extend(double energy, double potential) {
  lowest = std::min(lowest, energy);
  highest = std::max(highest, energy);
  lowest_potential = std::min(lowest_potential, potential);
}

EnergyLimiter::EnergyLimiter(std::vector<BodyId> group, const std::vector<MovingBody>& bodies)
    : group_(std::move(group)) {
  assert(!group_.empty() && std::ranges::is_sorted(group_));
  for (const BodyId id : group_) {
    const Body& body = bodies[id].body;
    floor_ += least_energy_scale(body);
    in_still_water_ = in_still_water_ && must_not_gain_energy(body);
  }
}

bool EnergyLimiter::judge(const std::vector<SubstepBody*>& members, double h, bool halves) {
  assert(std::ranges::equal(members, group_, {}, &SubstepBody::id));
  excess_ = 0;
  next_ = range_;
  if (!in_still_water_) return false;
  if (std::any_of(members.begin(), members.end(), [](const auto* b) { return b->touching; })) {
    next_ = {};
    return false;
  }
  if (std::any_of(members.begin(), members.end(), [](auto* b) { return is_driven(*b->moving); }))
    next_.lowest = std::numeric_limits<double>::infinity();
  for (const SubstepBody* b : members) next_.lowest += b->row_work + b->inflow_work;
  const auto suspect = [h](const SubstepBody* b) { return is_suspect(*b, h); };
  if (!halves && std::none_of(members.begin(), members.end(), suspect)) return false;
  judge_energy(members, h);
  return excess_ > allowed_;
}

void EnergyLimiter::judge_energy(const std::vector<SubstepBody*>& members, double h) {
  double before = 0, potential_before = 0, potential = 0, remembered = 0, work = 0, given = 0;
  kinetic_ = 0;
  for (const SubstepBody* b : members) {
    const Motion& start = b->moving->motion;
    const double stored = potential_energy(b->body(), start);
    potential_before += stored;
    before += stored + memory_energy(b->body(), start) +
              kinetic_energy(b->body(), start, b->body().current());
    potential += potential_energy(b->body(), b->end);
    kinetic_ += kinetic_energy(b->body(), b->end, b->body().current());
    remembered += memory_energy(b->body(), b->end);
    given += b->row_work + b->inflow_work;
    if (is_driven(*b->moving)) work += work_done(*b->moving, start.state, b->end.state, h);
  }
  const double earlier = next_.lowest;  // what rows and inflow have given is in it
  next_.extend(before, potential_before);
  next_.lowest = std::min(earlier, before + given) + work;
  const double energy = potential + kinetic_ + remembered;
  allowed_ = kEnergyGain * std::max(next_.highest - next_.lowest_potential, floor_);
  excess_ = energy - next_.lowest - allowed_;
  next_.extend(std::min(energy, energy - excess_), potential);
}

void EnergyLimiter::clamp(const std::vector<SubstepBody*>& members) {
  assert(std::ranges::equal(members, group_, {}, &SubstepBody::id));
  range_ = next_;
  if (!(excess_ > 0)) return;
  const bool enough = kinetic_ > excess_;
  const bool much = excess_ > allowed_;
  if (!enough && !much) return;
  const double fraction = enough ? std::sqrt(1 - excess_ / kinetic_) : 0;
  for (SubstepBody* b : members) {
    Eigen::Vector3d frame = Eigen::Vector3d::Zero();
    if (in_still_water_) frame = b->body().current();
    if (!enough) b->end = b->moving->motion;
    const Motion fast = b->end;
    b->end.state = with_velocity(fast.state, fraction * velocity(fast.state, frame), frame);
    if (b->end.work) record_clamp(b->body(), fast, b->end);
    if (!much) continue;
    b->end.accelerations.clear();
    ++b->moving->counts.clamped;
  }
}

}  // namespace engine
