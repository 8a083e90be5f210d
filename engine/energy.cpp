#include "engine/energy.h"

#include <algorithm>
#include <cmath>

#include "hydro/statics/buoyancy_energy.h"

namespace engine {

double kinetic_energy(const Body& body, const Motion& motion, const Eigen::Vector3d& frame) {
  const hydro::BodyState& state = motion.state;
  const Vector6d u =
      rotate(state.orientation.conjugate().toRotationMatrix(), velocity(state, frame));
  return u.dot((body.rigid_B + motion.added()) * u) / 2;
}

double potential_energy(const Body& body, const hydro::BodyState& state) {
  const Environment& environment = body.environment;
  const double weight =
      body.spec->mass * environment.gravity * (state.position.z() - environment.level);
  const bool lifted = body.wet && body.spec->coefficients.buoyancy && may_be_wet(body, state);
  return lifted ? weight + hydro::buoyancy_energy(*body.hull, state, *environment.sea) : weight;
}

double least_energy_scale(const Body& body) {
  const double radius = body.radius;
  const double water =
      body.environment.sea ? body.environment.sea->density * std::pow(radius, 3) : 0;
  return 1e-9 * body.environment.gravity * (body.spec->mass + water) * radius;
}

bool must_not_gain_energy(const Body& body) {
  // The energy is relative to the water, and a current does work on a body that locks or joints
  // stop.
  const bool drifts = !body.locked && !body.jointed;
  return body.wet && hydro::is_flat(*body.environment.sea) && body.current().z() == 0 &&
         (drifts || body.current().isZero(0));
}

bool is_driven(const MovingBody& moving) {
  return moving.body.spec->coefficients.lift != 0 || !moving.body.spec->loads.empty() ||
         !moving.inputs.loads.empty() || moving.inputs.pull;
}

double work_done(const MovingBody& moving, const hydro::BodyState& before,
                 const hydro::BodyState& after, double h) {
  const Eigen::Vector3d current = moving.body.current();
  hydro::Wrench load = moving.cache.loads.water.lift;
  for (const hydro::Wrench& applied : moving.cache.loads.applied) load += applied;
  const Vector6d F = to_vector6(load);
  return h * std::max({0.0, F.dot(velocity(before, current)), F.dot(velocity(after, current))});
}

}  // namespace engine
