#include <ode/ode.h>

#include <algorithm>
#include <cmath>

#include "engine/world.h"

namespace engine {
namespace {

// Least mass and moment of inertia as numbers in SI that the solver is trusted with as they are.
// With those of bodies of a millimetre, 1e-20, it fails in contacts that it solves for the same
// bodies a thousand million times as heavy.
constexpr double kLeastMass = 1e-6;

// The direct solver's time grows with the third power of the number of contact points, that of the
// iterative one in proportion; from about so many the latter is the quicker one.
constexpr int kMostDirectContacts = 32;
// A tower of twenty crates stands as with the direct solver; ten times as many change nothing.
constexpr int kHeapIterations = 50;

void set_mass(dxBody* body, double mass, const Eigen::Matrix3d& inertia) {
  dMass parameters;
  dMassSetParameters(&parameters, mass, 0, 0, 0, inertia(0, 0), inertia(1, 1), inertia(2, 2),
                     inertia(0, 1), inertia(0, 2), inertia(1, 2));
  dBodySetMass(body, &parameters);
}

/// True if nothing but contacts holds these bodies, and so many that they are to be solved for by
/// iteration. Contacts give way, so that it settles soon; joints do not.
bool is_heap(const std::vector<dxBody*>& bodies) {
  int contacts = 0;
  for (dxBody* body : bodies)
    for (int i = 0, count = dBodyGetNumJoints(body); i < count; ++i) {
      dxJoint* joint = dBodyGetJoint(body, i);
      if (dJointGetType(joint) != dJointTypeContact) return false;
      // One between two bodies is met from either.
      contacts += dJointGetBody(joint, 0) && dJointGetBody(joint, 1) ? 1 : 2;
    }
  return contacts > 2 * kMostDirectContacts;
}

}  // namespace

void World::only_constrain() {
  // A power of two: numbers keep their digits.
  if (lightest_ < kLeastMass) unit_ = std::exp2(-std::floor(std::log2(lightest_)));
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

std::vector<hydro::Twist> World::constrained_velocities(const std::vector<Constrained>& bodies,
                                                        double step) {
  const std::lock_guard lock(*answering_);
  open_ode();
  const auto ready = [&] {
    for (const Constrained& c : bodies) {
      dxBody* body = handle_of(c.body);
      const Eigen::Vector3d force = unit_ * c.load.force;
      const Eigen::Vector3d moment = unit_ * c.load.moment;
      set_state(c.body, c.state);
      set_mass(body, unit_ * c.mass, unit_ * c.inertia_B);
      dBodySetForce(body, force.x(), force.y(), force.z());
      dBodySetTorque(body, moment.x(), moment.y(), moment.z());
      dBodyEnable(body);
    }
  };
  ready();
  take_ode_warning();
  std::vector<dxBody*> handles;
  for (const Constrained& c : bodies) handles.push_back(handle_of(c.body));
  if (is_heap(handles)) {
    iterate(kHeapIterations, step);
  } else {
    if (!dWorldStep(world_.get(), step)) throw OdeFault("ODE: no memory for the step");
    if (!take_ode_warning().empty()) {
      ++compromises_;
      ready();
      iterate(kFallbackIterations, step);
    }
  }
  std::vector<hydro::Twist> velocities;
  for (const Constrained& c : bodies) {
    const hydro::BodyState after = state(c.body);
    velocities.push_back({after.linear_velocity, after.angular_velocity});
    set_state(c.body, c.state);
    dBodyDisable(handle_of(c.body));
  }
  return velocities;
}

void World::iterate(int count, double step) {
  dWorldSetQuickStepNumIterations(world_.get(), count);
  dRandSetSeed(1);  // It takes the constraints in random order.
  if (!dWorldQuickStep(world_.get(), step)) throw OdeFault("ODE: no memory for the step");
}

}  // namespace engine
