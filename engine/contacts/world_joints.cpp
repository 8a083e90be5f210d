#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <stdexcept>

#include "engine/base/constants.h"
#include "engine/contacts/world.h"

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
    case JointSpec::Type::ball: {
      dxJoint* ball = attached(dJointCreateBall(world, nullptr));
      dJointSetBallAnchor(ball, p.x(), p.y(), p.z());
      return;
    }
    case JointSpec::Type::hinge: {
      dxJoint* hinge = attached(dJointCreateHinge(world, nullptr));
      dJointSetHingeAnchor(hinge, p.x(), p.y(), p.z());
      dJointSetHingeAxis(hinge, e.x(), e.y(), e.z());
      return;
    }
    case JointSpec::Type::slider: {
      dxJoint* slider = attached(dJointCreateSlider(world, nullptr));
      dJointSetSliderAxis(slider, e.x(), e.y(), e.z());
      return;
    }
    case JointSpec::Type::fixed: {
      dJointSetFixed(attached(dJointCreateFixed(world, nullptr)));
      return;
    }
    case JointSpec::Type::universal: {
      dxJoint* universal = attached(dJointCreateUniversal(world, nullptr));
      dJointSetUniversalAnchor(universal, p.x(), p.y(), p.z());
      dJointSetUniversalAxis1(universal, e.x(), e.y(), e.z());
      dJointSetUniversalAxis2(universal, e2.x(), e2.y(), e2.z());
      return;
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
  create_joint(world_.get(), spec, handle_of(spec.first), handle_of(spec.second));
  // A body that cannot move is a part of the world.
  const auto movable = [this](BodyId id) { return handle_of(id) ? id : kWorld; };
  const auto start = [this](BodyId id) {
    return id == kWorld ? hydro::BodyState{} : bodies_[id].initial;
  };
  const std::array<BodyId, 2> ids{movable(spec.first), movable(spec.second)};
  frames_.push_back(joint_frames(spec, index, ids, start(ids[0]), start(ids[1])));
}

std::vector<JointFrames> World::joints_of(const std::vector<BodyId>& bodies) const {
  const auto is_here = [&](BodyId id) { return std::ranges::binary_search(bodies, id); };
  std::vector<JointFrames> found;
  for (const JointFrames& joint : frames_)
    if (is_here(joint.bodies[0]) || is_here(joint.bodies[1])) found.push_back(joint);
  return found;
}

}  // namespace engine
