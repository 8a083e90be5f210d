#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <stdexcept>

#include "engine/world.h"

namespace engine {
namespace {

dxJoint* create(dxWorld* world, JointSpec::Type type) {
  switch (type) {
    case JointSpec::Type::ball:
      return dJointCreateBall(world, nullptr);
    case JointSpec::Type::hinge:
      return dJointCreateHinge(world, nullptr);
    case JointSpec::Type::slider:
      return dJointCreateSlider(world, nullptr);
    case JointSpec::Type::fixed:
      return dJointCreateFixed(world, nullptr);
    case JointSpec::Type::universal:
      return dJointCreateUniversal(world, nullptr);
  }
  throw std::invalid_argument("a joint of no known type");
}

/// Tells the joint where it is; the bodies must already be in place and attached.
void align(dxJoint* joint, const JointSpec& spec) {
  const Eigen::Vector3d& anchor = spec.anchor_W;
  const Eigen::Vector3d& axis = spec.axis_W;
  const Eigen::Vector3d& axis2 = spec.axis2_W;
  switch (spec.type) {
    case JointSpec::Type::ball:
      dJointSetBallAnchor(joint, anchor.x(), anchor.y(), anchor.z());
      break;
    case JointSpec::Type::hinge:
      dJointSetHingeAnchor(joint, anchor.x(), anchor.y(), anchor.z());
      dJointSetHingeAxis(joint, axis.x(), axis.y(), axis.z());
      break;
    case JointSpec::Type::slider:
      dJointSetSliderAxis(joint, axis.x(), axis.y(), axis.z());
      break;
    case JointSpec::Type::fixed:
      dJointSetFixed(joint);
      break;
    case JointSpec::Type::universal:
      dJointSetUniversalAnchor(joint, anchor.x(), anchor.y(), anchor.z());
      dJointSetUniversalAxis1(joint, axis.x(), axis.y(), axis.z());
      dJointSetUniversalAxis2(joint, axis2.x(), axis2.y(), axis2.z());
      break;
  }
}

}  // namespace

void World::add_joint(const JointSpec& spec) {
  const auto known = [this](BodyId id) {
    return id == kWorld || (id >= 0 && id < static_cast<BodyId>(bodies_.size()));
  };
  if (spec.first == spec.second || !known(spec.first) || !known(spec.second)) {
    throw std::invalid_argument(fmt::format(
        "joint '{}': it must join two different bodies, or a body and the world", spec.name));
  }
  const Pair pair = std::minmax(spec.first, spec.second);
  // The ground is no body: what is jointed to the world still stands on it.
  if (pair.first != kWorld)
    jointed_.insert(std::lower_bound(jointed_.begin(), jointed_.end(), pair), pair);
  // Two immovable bodies keep any joint by themselves.
  if (!handle_of(spec.first) && !handle_of(spec.second)) return;
  joints_.push_back(pair);
  for (const BodyId id : {spec.first, spec.second})
    if (id != kWorld) bodies_[static_cast<std::size_t>(id)].held = true;
  dxJoint* joint = create(world_.get(), spec.type);
  dJointAttach(joint, handle_of(spec.first), handle_of(spec.second));
  align(joint, spec);
}

}  // namespace engine
