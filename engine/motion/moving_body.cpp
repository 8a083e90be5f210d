#include "engine/motion/moving_body.h"

#include <cmath>
#include <numbers>

#include "engine/base/stopwatch.h"

namespace engine {
namespace {

/// The load at a time: moment about the centre of mass, in W.
hydro::Wrench wrench(const AppliedLoad& load, const hydro::BodyState& state, double time,
                     const SetPoints* set_points) {
  // A multiple of the step differs from the time as written by round-off.
  const double later = time + 1e-12 * std::abs(time);
  if (later < load.start || later >= load.end) return {};
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const Eigen::Vector3d force = load.in_body_frame ? R_WB * load.force : load.force;
  const Eigen::Vector3d torque = load.in_body_frame ? R_WB * load.torque : load.torque;
  const hydro::Wrench whole{.force = force, .moment = torque + (R_WB * load.at_B).cross(force)};
  if (load.factor) return set_points->value(*load.factor, time) * whole;
  if (!load.sine) return whole;
  return std::sin(2 * std::numbers::pi * load.sine->frequency * time + load.sine->phase) * whole;
}

}  // namespace

std::vector<hydro::Wrench> applied_loads(const MovingBody& moving, const hydro::BodyState& state,
                                         double time) {
  std::vector<hydro::Wrench> loads;
  for (const AppliedLoad& load : moving.body.spec->loads)
    loads.push_back(wrench(load, state, time, moving.set_points));
  for (const AppliedLoad& load : moving.inputs.loads)
    loads.push_back(wrench(load, state, time, moving.set_points));
  if (moving.motion.suction && moving.motion.suction->force > 0)
    loads.push_back(wrench(*moving.motion.suction, state));
  if (moving.inputs.pull) {
    const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
    loads.push_back(
        wrench(*moving.inputs.pull, inertia_W(moving.body, moving.motion, R_WB), state));
  }
  return loads;
}

const char* misfit(const MovingBody& moving, const Motion& motion) {
  if (!fits_memory(moving.body, motion)) return "another memory of waves";
  if (!fits_water(moving.body, motion)) return "other pockets";
  if (motion.suction.has_value() != moving.motion.suction.has_value()) return "another bed";
  return nullptr;
}

std::vector<double> pump_rates(const MovingBody& moving, double time) {
  std::vector<double> rates;
  for (const PumpSpec& pump : moving.body.spec->pumps)
    rates.push_back(moving.set_points->value(pump.rate, time));
  return rates;
}

hydro::Loads water_loads(const Body& body, const Motion& motion, const hydro::BodyState& state,
                         double time) {
  const hydro::Sea* sea = body.environment.sea;
  hydro::Loads loads;
  if (body.wet)
    loads = sea_loads(body, motion, state, time, body.spec->coefficients, body.spec->summation);
  if (holds_water(motion)) add_carried_loads(body, *motion.carried_water, state, time, loads);
  const double formed = formed_wake(body, motion, state);
  const bool sheds = formed < 1 && !body.wake->edges.none();
  loads.pressure_drag = formed * loads.pressure_drag;
  if (loads.wetted_area > 0 && (body.spec->resistance || body.hull_lift || sheds)) {
    const hydro::HullWater water = water_about(body, state, time);
    if (body.spec->resistance)
      loads.resistance = hydro::resistance_load(*body.spec->resistance, state, water.velocity,
                                                loads.displaced_volume);
    if (body.hull_lift) loads.hull_lift = body.hull_lift->load(state, water);
    if (sheds) loads.pressure_drag += (1 - formed) * body.wake->edges.load(state, water);
  }
  if (!body.has_wave_load) return loads;
  if (body.spec->radiation)
    loads.diffraction = body.spec->radiation->wave_load(state, *sea, time);
  else
    loads.wave_inertia = body.spec->added_mass->wave_load(state, *sea, time);
  return loads;
}

hydro::Wrench find_loads(MovingBody& moving, const Motion& motion, const hydro::BodyState& state,
                         double time) {
  const BodySpec& spec = *moving.body.spec;
  LoadCache& cache = moving.cache;
  BodyLoads& loads = cache.loads;
  loads.applied = applied_loads(moving, state, time);
  loads.weight = {.force = {0, 0, -spec.mass * moving.body.environment.gravity}};
  loads.lines = moving.rig_load;
  if (moving.machines) loads.machines = moving.machines->load(moving.id, state, time);
  const bool meets_water = moving.body.wet || moving.body.has_wave_load;
  const bool stays_dry = meets_water && !holds_water(motion) && !may_be_wet(moving.body, state);
  moving.counts.dry += stays_dry;
  if (stays_dry && !moving.body.feels_air) {
    loads.water = {};
    cache.water_state.reset();
  } else if (meets_water && cache.water_state == state &&
             cache.carried_water == motion.carried_water && cache.wake == motion.wake) {
    ++moving.counts.resting;
  } else if (meets_water) {
    const Stopwatch stopwatch(cache.seconds);
    loads.water = water_loads(moving.body, motion, state, time);
    cache.carried_water = motion.carried_water;
    cache.wake = motion.wake;
    cache.water_state.reset();
    if (!hydro::changes_with_time(*moving.body.environment.sea)) cache.water_state = state;
  }
  const hydro::Wrench total = loads.total();
  if (!total.force.allFinite() || !total.moment.allFinite())
    throw MotionFault(moving.body, load_fault(loads));
  return total;
}

void restore_cache(MovingBody& moving, const std::optional<hydro::BodyState>& water_state) {
  moving.cache.water_state.reset();
  if (water_state && moving.body.wet) find_loads(moving, *water_state, 0);
}

void check_state(const MovingBody& moving, const hydro::BodyState& state) {
  if (const auto fault = state_fault(state))
    throw MotionFault(moving.body, *fault + " after the step; " + largest_load(moving.cache.loads));
}

}  // namespace engine
