#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/constants.h"
#include "engine/world.h"

namespace engine {
namespace {

/// Makes a joint between bodies that are in place; null stands for the world.
void create_joint(dxWorld* world, const JointSpec& spec, dxBody* first, dxBody* second) {
  const Eigen::Vector3d& p = spec.anchor_W;
  const Eigen::Vector3d& e = spec.axis_W;
  const Eigen::Vector3d& e2 = spec.axis2_W;
  const auto attached = [&](dxJoint* joint) {
    dJointAttach(joint, first, second);
    return joint;
  };
  switch (spec.type) {
    case JointSpec::Type::ball:
      return dJointSetBallAnchor(attached(dJointCreateBall(world, nullptr)), p.x(), p.y(), p.z());
    case JointSpec::Type::hinge: {
      dxJoint* hinge = attached(dJointCreateHinge(world, nullptr));
      dJointSetHingeAnchor(hinge, p.x(), p.y(), p.z());
      return dJointSetHingeAxis(hinge, e.x(), e.y(), e.z());
    }
    case JointSpec::Type::slider:
      return dJointSetSliderAxis(attached(dJointCreateSlider(world, nullptr)), e.x(), e.y(), e.z());
    case JointSpec::Type::fixed:
      return dJointSetFixed(attached(dJointCreateFixed(world, nullptr)));
    case JointSpec::Type::universal: {
      dxJoint* universal = attached(dJointCreateUniversal(world, nullptr));
      dJointSetUniversalAnchor(universal, p.x(), p.y(), p.z());
      dJointSetUniversalAxis1(universal, e.x(), e.y(), e.z());
      return dJointSetUniversalAxis2(universal, e2.x(), e2.y(), e2.z());
    }
  }
  throw std::invalid_argument("a joint of no known type");
}

}  // namespace

void World::add_joint(const JointSpec& spec) {
  const auto known = [this](BodyId id) {
    return id == kWorld || (id >= 0 && id < static_cast<BodyId>(bodies_.size()));
  };
  if (spec.first == spec.second || !known(spec.first) || !known(spec.second))
    throw std::invalid_argument(fmt::format(
        "joint '{}': it must join two different bodies, or a body and the world", spec.name));
  const Pair pair = std::minmax(spec.first, spec.second);
  // The ground is no body: bodies that are jointed to the world still touch it.
  if (pair.first != kWorld)
    jointed_.insert(std::lower_bound(jointed_.begin(), jointed_.end(), pair), pair);
  // A joint between two immovable bodies constrains nothing.
  if (!handle_of(spec.first) && !handle_of(spec.second)) return;
  joints_.push_back(pair);
  for (const BodyId id : {spec.first, spec.second})
    if (id != kWorld) bodies_[id].constrained = true;
  create_joint(world_.get(), spec, handle_of(spec.first), handle_of(spec.second));
}

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

std::vector<hydro::Twist> World::constrained_velocities(const std::vector<SolverBody>& bodies,
                                                        const std::vector<Contact>& contacts,
                                                        double step) {
  const auto is_constrained = [this](const SolverBody& b) {
    return bodies_.at(b.body).constrained;
  };
  const IslandProblem problem{.bodies = bodies, .contacts = contacts, .step = step, .unit = unit_};
  if (std::none_of(bodies.begin(), bodies.end(), is_constrained))
    return island_solver_->velocities(problem);
  // Joints and locks are in the world of all bodies, which solves one island at a time.
  const std::lock_guard lock(*mutex_);
  open_ode();
  std::vector<dxBody*> handles;
  for (const SolverBody& b : bodies) handles.push_back(handle_of(b.body));
  std::vector<hydro::Twist> velocities =
      solve(world_.get(), contact_joints_.get(), handles, problem, true);
  for (const SolverBody& b : bodies) set_state(b.body, b.state);
  return velocities;
}

}  // namespace engine
