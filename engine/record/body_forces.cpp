#include "engine/record/body_forces.h"

#include "engine/motion/moving_body.h"

namespace engine {

BodyForces forces_on(const MovingBody& moving, const hydro::Wrench& lines, double time,
                     double step) {
  const Body& body = moving.body;
  const Motion& motion = moving.motion;
  const hydro::BodyState& state = motion.state;
  const WorkRecord& record = *motion.work;
  BodyForces forces{.works = works_of(body, motion)};
  for (const hydro::Wrench& load : applied_loads(moving, state, time)) forces.applied += load;
  forces.radiation = to_wrench(memory_load(body, motion, time));
  forces.lines = lines + to_wrench(record.row_impulse / step);
  if (moving.machines) {
    forces.machines = moving.machines->load(moving.id, state, time);
    const Eigen::Vector3d H = state.orientation * moving.machines->rotors_B(moving.id, time);
    forces.machines.moment -= state.angular_velocity.cross(H);
  }
  forces.weight.force.z() = -body.spec->mass * body.environment.gravity;
  if (body.feels_air || holds_water(motion) || may_be_wet(body, state))
    forces.water = water_loads(body, motion, state, time);
  forces.added_mass = to_wrench(record.added_impulse / step);
  forces.constraint = to_wrench(record.constraint_impulse / step);
  if (body.held())
    forces.constraint =
        -1.0 * (forces.weight + forces.applied + forces.water.total() + forces.radiation +
                forces.lines + forces.machines + forces.added_mass);
  if (motion.water) {
    forces.simulated_water = forces.radiation + forces.water.diffraction;
    forces.radiation = forces.water.diffraction = {};
  }
  forces.kinetic_energy = own_kinetic_energy(body, motion);
  forces.added_kinetic_energy = added_kinetic_energy(body, motion);
  forces.potential_energy =
      body.spec->mass * body.environment.gravity * (state.position.z() - body.environment.level);
  return forces;
}

}  // namespace engine
