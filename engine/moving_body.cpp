#include "engine/moving_body.h"

#include <cmath>
#include <numbers>

#include "engine/stopwatch.h"

namespace engine {
namespace {

/// Puts the loads of the water in a state into the cache.
void compute_water_loads(MovingBody& moving, const Environment& environment,
                         const hydro::BodyState& state, double time) {
  const BodySpec& spec = *moving.body.spec;
  moving.cache.loads.water = hydro::compute_loads(*moving.body.hull, state, *environment.sea, time,
                                                  spec.coefficients, spec.summation);
  if (hydro::changes_with_time(*environment.sea))
    moving.cache.water_state.reset();
  else
    moving.cache.water_state = state;
}

/// The load at a time: moment about the centre of mass, in W.
hydro::Wrench wrench(const AppliedLoad& load, const hydro::BodyState& state, double time) {
  // A multiple of the step differs from the time as written by round-off.
  const double later = time + 1e-12 * std::abs(time);
  if (later < load.start || later >= load.end) return {};
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const Eigen::Vector3d force = load.in_body_frame ? R_WB * load.force : load.force;
  const Eigen::Vector3d torque = load.in_body_frame ? R_WB * load.torque : load.torque;
  const hydro::Wrench whole{.force = force, .moment = torque + (R_WB * load.at_B).cross(force)};
  if (!load.sine) return whole;
  return std::sin(2 * std::numbers::pi * load.sine->frequency * time + load.sine->phase) * whole;
}

/// Finds the loads of the water: none above its highest point, and those of the cache where neither
/// body nor water has moved.
void find_water_loads(MovingBody& moving, const Environment& environment,
                      const hydro::BodyState& state, double time) {
  LoadCache& cache = moving.cache;
  if (!may_be_wet(moving.body, environment, state)) {
    ++moving.counts.dry;
    cache.loads.water = {};
    cache.water_state.reset();
  } else if (cache.water_state == state) {
    ++moving.counts.resting;
  } else {
    compute_water_loads(moving, environment, state, time);
  }
}

}  // namespace

void restore_cache(MovingBody& moving, const Environment& environment,
                   const std::optional<hydro::BodyState>& water_state) {
  moving.cache.water_state.reset();
  if (water_state && moving.body.wet) compute_water_loads(moving, environment, *water_state, 0);
}

std::vector<hydro::Wrench> applied_loads(const MovingBody& moving, const hydro::BodyState& state,
                                         double time) {
  std::vector<hydro::Wrench> loads;
  for (const AppliedLoad& load : moving.body.spec->loads)
    loads.push_back(wrench(load, state, time));
  for (const AppliedLoad& load : moving.inputs.loads) loads.push_back(wrench(load, state, time));
  if (moving.inputs.pull) {
    const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
    loads.push_back(
        wrench(*moving.inputs.pull, inertia_W(moving.body, moving.motion, R_WB), state));
  }
  return loads;
}

hydro::Wrench find_loads(MovingBody& moving, const Environment& environment,
                         const hydro::BodyState& state, double time) {
  BodyLoads& loads = moving.cache.loads;
  loads.applied = applied_loads(moving, state, time);
  loads.weight = {.force = {0, 0, -moving.body.spec->mass * environment.gravity}};
  if (moving.body.wet) {
    const Stopwatch stopwatch(moving.cache.seconds);
    find_water_loads(moving, environment, state, time);
  }
  const hydro::Wrench total = loads.total();
  if (!total.force.allFinite() || !total.moment.allFinite())
    throw MotionFault(moving.body, load_fault(loads).value());
  return total;
}

Matrix6d find_added_mass(MovingBody& moving, const Environment& environment,
                         const hydro::BodyState& state, double time) {
  const Stopwatch stopwatch(moving.cache.seconds);
  return added_mass(moving.body, environment, state, time);
}

void check_state(const MovingBody& moving, const hydro::BodyState& state) {
  if (const auto fault = state_fault(state))
    throw MotionFault(moving.body, *fault + " after the step; " + largest_load(moving.cache.loads));
}

}  // namespace engine
