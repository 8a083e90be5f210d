#include "engine/energy.h"

#include <algorithm>
#include <cmath>

#include "engine/wetness.h"
#include "hydro/statics/buoyancy_energy.h"

namespace engine {

double kinetic_energy(const Body& body, const Surroundings& around, const Motion& motion) {
  const hydro::BodyState& state = motion.state;
  const Vector6d u =
      turned(state.orientation.conjugate().toRotationMatrix(), velocity(state, around.current()));
  return u.dot((body.rigid_B + motion.added()) * u) / 2;
}

double potential_energy(const Body& body, const Surroundings& around,
                        const hydro::BodyState& state) {
  const double height = state.position.z() - (around.sea ? around.sea->level : 0);
  const double weight = body.spec->mass * around.gravity * height;
  const bool lifted = body.wet && body.spec->coefficients.buoyancy &&
                      lowest_point(body.box_B, state) < around.highest;
  return lifted ? weight + hydro::buoyancy_energy(*body.hull, state, *around.sea) : weight;
}

double energy(const Body& body, const Surroundings& around, const Motion& motion) {
  return kinetic_energy(body, around, motion) + potential_energy(body, around, motion.state);
}

double least_energy_scale(const Body& body, const Surroundings& around) {
  const double radius = body.radius;
  const double water = around.sea ? around.sea->density * std::pow(radius, 3) : 0;
  return 1e-9 * around.gravity * (body.spec->mass + water) * radius;
}

bool must_not_gain_energy(const Body& body, const Surroundings& around) {
  // Energy is that of the motion relative to the water: what is held in a current gets some.
  const bool drifts = !body.locked && !body.jointed;
  return body.wet && hydro::is_flat(*around.sea) && around.current().z() == 0 &&
         (drifts || around.current().isZero(0));
}

bool is_driven(const Body& body) {
  return body.spec->coefficients.lift != 0 || !body.spec->loads.empty() || body.pull;
}

double work_done(const Body& body, const Surroundings& around, const hydro::BodyState& before,
                 const hydro::BodyState& after, double h) {
  hydro::Wrench load = body.loads.water.lift;
  for (const hydro::Wrench& applied : body.loads.applied) load += applied;
  const Vector6d F = stacked(load);
  return h * std::max({0.0, F.dot(velocity(before, around.current())),
                       F.dot(velocity(after, around.current()))});
}

double total_energy(const SimulationSpec& spec, const std::vector<hydro::BodyState>& states) {
  const Surroundings around = surroundings(spec);
  double sum = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Body body = make_body(spec, i);
    if (!body.movable) continue;
    Motion motion{.state = states[i]};
    if (body.adds) motion.added_B = body.spec->added_mass->at(states[i], *spec.sea, 0);
    sum += energy(body, around, motion);
  }
  return sum;
}

}  // namespace engine
