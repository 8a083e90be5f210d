#include "engine/step/ode_step.h"

#include "engine/hollows/flooding.h"
#include "engine/motion/locks.h"

namespace engine {
namespace {

void apply_loads(World& world, MovingBody& moving, BodyId id, double time, double step) {
  const hydro::BodyState& state = moving.motion.state;
  world.set_state(id, state);
  hydro::Wrench load = find_loads(moving, state, time);
  if (const auto fault = motion_fault(*moving.body.spec, state, load, step))
    throw MotionFault(moving.body, *fault + " after the step; " + largest_load(moving.cache.loads));
  load += -1.0 * moving.cache.loads.weight;  // ODE's own
  world.apply(id, load);
}

}  // namespace

std::vector<Overlap> ode_step(const StepContext& context, double time, double step) {
  World& world = context.world;
  std::vector<MovingBody>& bodies = context.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    context.check_stop();
    if (bodies[i].body.movable) apply_loads(world, bodies[i], static_cast<BodyId>(i), time, step);
  }
  if (context.collides) world.collide(step);
  world.advance(step);
  std::vector<bool> touching(bodies.size(), false);
  for (const Pair& pair : world.contacts().pairs)
    for (const BodyId id : {pair.first, pair.second})
      if (id != kWorld) touching[id] = true;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    MovingBody& moving = bodies[i];
    const Body& body = moving.body;
    const auto id = static_cast<BodyId>(i);
    hydro::BodyState next = world.state(id);
    if (body.locked) next = project_onto_locks(body.spec->locked, body.spec->initial, next);
    check_state(moving, next);
    const Motion before = moving.motion;
    moving.motion.state = next;
    let_water_run(body, before.state, time + step, step, pump_rates(moving, time + step / 2),
                  moving.motion);
    if (moving.motion.work)
      record_ode_step(moving, before, step, body.jointed || body.locked || touching[i],
                      moving.motion);
    ++moving.counts.constrained;
    ++moving.counts.substeps;
  }
  std::vector<Overlap> overlaps;
  add_overlaps(world.contacts().points, time, overlaps);
  return overlaps;
}

}  // namespace engine
