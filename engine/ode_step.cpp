#include "engine/ode_step.h"

#include "engine/locks.h"

namespace engine {
namespace {

void apply_loads(World& world, Body& body, BodyId id, const Surroundings& around, double time,
                 double step) {
  hydro::Wrench load = find_loads(body, around, body.motion.state, time);
  if (const auto fault = motion_fault(*body.spec, body.motion.state, load, step))
    throw MotionFault(body, *fault + " after the step; " + largest_load(body.loads));
  load += -1.0 * body.loads.weight;  // ODE's own
  world.apply(id, load);
}

}  // namespace

void ode_step(World& world, std::vector<Body>& bodies, const Surroundings& around, double time,
              double step, bool collides) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].movable)
      apply_loads(world, bodies[i], static_cast<BodyId>(i), around, time, step);
  if (collides) world.collide(step);
  world.advance(step);
  const std::vector<bool> touching = world.touching();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body& body = bodies[i];
    const auto id = static_cast<BodyId>(i);
    hydro::BodyState next = world.state(id);
    if (body.locked) next = held(body.spec->locked, body.spec->initial, next);
    check_state(body, next);
    if (body.locked) world.set_state(id, next);
    const Motion before = body.motion;
    body.motion.state = next;
    if (body.motion.ledger)
      book_ode_step(body, before, step, body.jointed || body.locked || touching[i], body.motion);
    ++body.cost.constrained_steps;
    ++body.cost.substeps;
  }
}

}  // namespace engine
