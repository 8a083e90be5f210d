#include "engine/motion/energy.h"

#include "hydro/statics/buoyancy_energy.h"

namespace engine {
namespace {

/// True if the air, if there is any, moves everywhere as the water does.
bool is_calm(const Body& body) {
  if (!body.feels_air) return true;
  const hydro::Wind& wind = body.environment.sea->air->wind;
  return wind.uniform() && wind.velocity == body.current();
}

}  // namespace

double kinetic_energy(const Body& body, const Motion& motion, const Eigen::Vector3d& frame) {
  const hydro::BodyState& state = motion.state;
  const Vector6d u =
      rotate(state.orientation.conjugate().toRotationMatrix(), velocity(state, frame));
  return u.dot((body.rigid_B + motion.added()) * u) / 2;
}

double potential_energy(const Body& body, const Motion& motion) {
  const hydro::BodyState& state = motion.state;
  const Environment& environment = body.environment;
  double energy = body.spec->mass * environment.gravity * (state.position.z() - environment.level);
  if (holds_water(motion)) energy += carried_energy(body, *motion.carried_water, state);
  const bool lifted = body.wet && body.spec->coefficients.buoyancy && may_be_wet(body, state);
  if (lifted) energy += hydro::buoyancy_energy(sea_hull(body, motion), state, *environment.sea);
  return energy;
}

bool must_not_gain_energy(const Body& body) {
  // The energy is relative to the water, and a current does work on a body that locks or joints
  // stop, and under a height field, which does not drift with it.
  const hydro::Sea* sea = body.environment.sea;
  if (!body.wet || hydro::changes_with_time(*sea) || body.spec->sources) return false;
  const bool drifts = !body.locked && !body.jointed && !body.rigged && hydro::is_flat(*sea);
  return sea->profile.empty() && body.current().z() == 0 && is_calm(body) &&
         (drifts || body.current().isZero(0));
}

}  // namespace engine
