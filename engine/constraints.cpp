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
dxJoint* create_joint(dxWorld* world, const JointSpec& spec, dxBody* first, dxBody* second) {
  const Eigen::Vector3d& p = spec.anchor_W;
  const Eigen::Vector3d& e = spec.axis_W;
  const Eigen::Vector3d& e2 = spec.axis2_W;
  const auto attached = [&](dxJoint* joint) {
    dJointAttach(joint, first, second);
    return joint;
  };
  switch (spec.type) {
    case JointSpec::Type::ball: {
      dxJoint* ball = attached(dJointCreateBall(world, nullptr));
      dJointSetBallAnchor(ball, p.x(), p.y(), p.z());
      return ball;
    }
    case JointSpec::Type::hinge: {
      dxJoint* hinge = attached(dJointCreateHinge(world, nullptr));
      dJointSetHingeAnchor(hinge, p.x(), p.y(), p.z());
      dJointSetHingeAxis(hinge, e.x(), e.y(), e.z());
      return hinge;
    }
    case JointSpec::Type::slider: {
      dxJoint* slider = attached(dJointCreateSlider(world, nullptr));
      dJointSetSliderAxis(slider, e.x(), e.y(), e.z());
      return slider;
    }
    case JointSpec::Type::fixed: {
      dxJoint* fixed = attached(dJointCreateFixed(world, nullptr));
      dJointSetFixed(fixed);
      return fixed;
    }
    case JointSpec::Type::universal: {
      dxJoint* universal = attached(dJointCreateUniversal(world, nullptr));
      dJointSetUniversalAnchor(universal, p.x(), p.y(), p.z());
      dJointSetUniversalAxis1(universal, e.x(), e.y(), e.z());
      dJointSetUniversalAxis2(universal, e2.x(), e2.y(), e2.z());
      return universal;
    }
  }
  throw std::invalid_argument("a joint of no known type");
}

}  // namespace

void World::add_joint(const JointSpec& spec) {
  const std::size_t index = joint_count_++;
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
  dxJoint* joint = create_joint(world_.get(), spec, handle_of(spec.first), handle_of(spec.second));
  static_assert(sizeof(OdeFeedback) == sizeof(dJointFeedback), "ODE writes into it");
  reacting_.push_back({index, spec.first, spec.second, std::make_unique<OdeFeedback>()});
  dJointSetFeedback(joint, reinterpret_cast<dJointFeedback*>(reacting_.back().feedback.get()));
}

JointReaction World::reaction_of(const Joint& joint) const {
  // ODE's first body is the one that moves if the other does not. The force on the second one is
  // opposite to that on the first.
  const bool on_first = handle_of(joint.first) != nullptr;
  const double sign = (on_first ? -1 : 1) / unit_;
  return {.joint = joint.index,
          .force_W = sign * vector_from_ode(joint.feedback->f1),
          .moment_W = sign * vector_from_ode(joint.feedback->t1),
          .about_W = state(on_first ? joint.first : joint.second).position};
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

World::ConstrainedMotion World::constrained_motion(const std::vector<SolverBody>& bodies,
                                                   const std::vector<Contact>& contacts,
                                                   const std::vector<ForceRow>& rows, double step) {
  const auto is_constrained = [this](const SolverBody& b) {
    return bodies_.at(b.body).constrained;
  };
  const IslandProblem problem{
      .bodies = bodies, .contacts = contacts, .rows = rows, .step = step, .unit = unit_};
  if (std::none_of(bodies.begin(), bodies.end(), is_constrained))
    return {island_solver_->velocities(problem), {}};
  // Joints and locks are in the world of all bodies, which solves one island at a time.
  const std::lock_guard lock(*mutex_);
  open_ode();
  std::vector<dxBody*> handles;
  for (const SolverBody& b : bodies) handles.push_back(handle_of(b.body));
  ConstrainedMotion motion{solve(world_.get(), contact_joints_.get(), handles, problem, true), {}};
  for (const SolverBody& b : bodies) set_state(b.body, b.state);
  const auto is_here = [&](BodyId id) {
    return std::ranges::any_of(bodies, [id](const SolverBody& b) { return b.body == id; });
  };
  for (const Joint& joint : reacting_)
    if (is_here(joint.first) || is_here(joint.second))
      motion.reactions.push_back(reaction_of(joint));
  return motion;
}

}  // namespace engine
