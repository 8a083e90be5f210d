#include "engine/energy.h"

#include <algorithm>
#include <cmath>

#include "hydro/statics/buoyancy_energy.h"

namespace engine {

double kinetic_energy(const Body& body, const Environment& environment, const Motion& motion) {
  const hydro::BodyState& state = motion.state;
  const Vector6d u = rotate(state.orientation.conjugate().toRotationMatrix(),
                            velocity(state, environment.current()));
  return u.dot((body.rigid_B + motion.added()) * u) / 2;
}

double potential_energy(const Body& body, const Environment& environment,
                        const hydro::BodyState& state) {
  const double height = state.position.z() - (environment.sea ? environment.sea->level : 0);
  const double weight = body.spec->mass * environment.gravity * height;
  const bool lifted =
      body.wet && body.spec->coefficients.buoyancy && may_be_wet(body, environment, state);
  return lifted ? weight + hydro::buoyancy_energy(*body.hull, state, *environment.sea) : weight;
}

double least_energy_scale(const Body& body, const Environment& environment) {
  const double radius = body.radius;
  const double water = environment.sea ? environment.sea->density * std::pow(radius, 3) : 0;
  return 1e-9 * environment.gravity * (body.spec->mass + water) * radius;
}

bool must_not_gain_energy(const Body& body, const Environment& environment) {
  // The energy is relative to the water, and a current does work on a body that locks or joints
  // stop.
  const bool drifts = !body.locked && !body.jointed;
  return body.wet && hydro::is_flat(*environment.sea) && environment.current().z() == 0 &&
         (drifts || environment.current().isZero(0));
}

bool is_driven(const MovingBody& moving) {
  return moving.body.spec->coefficients.lift != 0 || !moving.body.spec->loads.empty() ||
         !moving.inputs.loads.empty() || moving.inputs.pull;
}

double work_done(const MovingBody& moving, const Environment& environment,
                 const hydro::BodyState& before, const hydro::BodyState& after, double h) {
  hydro::Wrench load = moving.cache.loads.water.lift;
  for (const hydro::Wrench& applied : moving.cache.loads.applied) load += applied;
  const Vector6d F = to_vector6(load);
  return h * std::max({0.0, F.dot(velocity(before, environment.current())),
                       F.dot(velocity(after, environment.current()))});
}

}  // namespace engine
