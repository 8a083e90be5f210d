#include <ode/ode.h>

#include <algorithm>
#include <cmath>

#include "engine/world.h"

namespace engine {
void World::only_constrain() {
  // ODE fails on contacts of bodies of a millimetre, with moments of inertia of 1e-20, that it
  // solves for the same bodies made heavier. A power of two keeps the digits of all numbers.
  if (lightest_ < kLeastSolverMass) unit_ = std::exp2(-std::floor(std::log2(lightest_)));
  dWorldSetCFM(world_.get(), dWorldGetCFM(world_.get()) / unit_);
  dWorldSetGravity(world_.get(), 0, 0, 0);
  for (const Body& body : bodies_) {
    if (!body.handle) continue;
    dBodySetGyroscopicMode(body.handle, 0);
    dBodyDisable(body.handle);
  }
}

void World::set_contact_inertia(BodyId id, const Inertia& inertia) {
  bodies_.at(static_cast<std::size_t>(id)).inertia = inertia;
}

std::vector<hydro::Twist> World::constrained_velocities(const std::vector<SolverBody>& bodies,
                                                        const std::vector<Contact>& contacts,
                                                        double step) {
  const auto is_held = [this](const SolverBody& b) {
    return bodies_.at(static_cast<std::size_t>(b.body)).held;
  };
  if (std::any_of(bodies.begin(), bodies.end(), is_held))
    return held_velocities(bodies, contacts, step);
  return apart_.velocities(unit_, bodies, contacts, step);
}

std::vector<hydro::Twist> World::held_velocities(const std::vector<SolverBody>& bodies,
                                                 const std::vector<Contact>& contacts,
                                                 double step) {
  const std::lock_guard lock(*answering_);
  open_ode();
  const auto ready = [&] {
    for (const SolverBody& b : bodies) hand_over(handle_of(b.body), b, unit_);
  };
  ready();
  for (const Contact& contact : contacts) join(contact);
  if (step_or_fall_back(world_.get(), ready, step)) ++fallback_steps_;
  dJointGroupEmpty(contact_joints_.get());
  std::vector<hydro::Twist> velocities;
  for (const SolverBody& b : bodies) {
    const hydro::BodyState after = state(b.body);
    velocities.push_back({after.linear_velocity, after.angular_velocity});
    set_state(b.body, b.state);
    dBodyDisable(handle_of(b.body));
  }
  return velocities;
}

}  // namespace engine
