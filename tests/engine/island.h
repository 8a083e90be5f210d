#pragma once

#include "engine/step/substep.h"
#include "tests/engine/specs.h"

namespace support {

/// All movable bodies of a specification as one island, with what a substep of it needs.
struct IslandOfAll {
  explicit IslandOfAll(engine::SimulationSpec description, bool constrained = true)
      : spec(std::move(description)),
        world(spec.gravity),
        rig(spec),
        bodies(moving_bodies(spec)),
        members(bodies.size()) {
    for (const engine::BodySpec& body : spec.bodies) world.add_body(body);
    for (const engine::JointSpec& joint : spec.joints) world.add_joint(joint);
    world.add_ground(spec.ground);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      members[i].id = static_cast<engine::BodyId>(i);
      members[i].moving = &bodies[i];
      members[i].halfway = bodies[i].motion;
      if (bodies[i].body.movable) island.bodies.push_back(&members[i]);
    }
    island.constrained = constrained;
  }
  IslandOfAll(const IslandOfAll&) = delete;
  IslandOfAll& operator=(const IslandOfAll&) = delete;

  /// Makes the midpoints of the bodies where they are, with their added mass at the end of the
  /// substep that of its start but for a factor.
  void make_midpoints(double growth = 1) {
    for (engine::SubstepBody* b : island.bodies)
      b->midpoint = engine::make_midpoint(b->body(), b->halfway, growth * b->halfway.added(),
                                          engine::Mobility{});
  }

  engine::SimulationSpec spec;
  engine::World world;
  engine::Rig rig;
  std::vector<engine::MovingBody> bodies;
  engine::StepContext context{
      .world = world,
      .rig = rig,
      .bodies = bodies,
      .gravity = spec.gravity,
      .parallel_for = [](std::size_t n, const std::function<void(std::size_t)>& f) {
        for (std::size_t i = 0; i < n; ++i) f(i);
      }};
  std::vector<engine::SubstepBody> members;
  engine::Island island;
};

}  // namespace support
