#include "engine/motion/reduced_joint.h"

#include "engine/motion/free_motion.h"
#include "engine/motion/locks.h"

namespace engine {
namespace {

using Eigen::Vector3d;
using Type = JointSpec::Type;

/// N of a ball joint at the point r from the centre of mass, in the axes of r.
Subspace turning_about(const Vector3d& r) {
  Subspace N(6, 3);
  for (int i = 0; i < 3; ++i) N.col(i) = to_vector6(Vector3d::Unit(i).cross(-r), Vector3d::Unit(i));
  return N;
}

}  // namespace

std::optional<ReducedJoint> find_reduced_joint(const SimulationSpec& spec, std::size_t index) {
  const BodySpec& body = spec.bodies[index];
  const auto id = static_cast<BodyId>(index);
  const JointSpec* only = nullptr;
  for (const JointSpec& joint : spec.joints) {
    if (joint.first != id && joint.second != id) continue;
    if (only) return std::nullopt;
    only = &joint;
  }
  if (!only || only->type == Type::universal) return std::nullopt;
  const BodyId other = only->first == id ? only->second : only->first;
  const bool grounded = other == kWorld || immovable(spec.bodies[other].locked);
  const bool in_current =
      spec.sea && body.added_mass && !(spec.sea->current.isZero(0) && spec.sea->profile.empty());
  const bool left_a_motion = only->type != Type::fixed;
  if (!grounded || (left_a_motion && (in_current || partly_locked(body.locked))))
    return std::nullopt;
  return ReducedJoint{.type = only->type,
                      .anchor_W = only->anchor_W,
                      .axis_W = only->axis_W,
                      .initial = body.initial,
                      .anchor_B = body.initial.orientation.conjugate() *
                                  Vector3d(only->anchor_W - body.initial.position)};
}

Subspace motion_subspace(const ReducedJoint& joint, const hydro::BodyState& state) {
  if (joint.type == Type::fixed) return Subspace(6, 0);
  const Vector3d r = joint.anchor_W - state.position;
  if (joint.type == Type::ball) return turning_about(r);
  if (joint.type == Type::hinge) return to_vector6(r.cross(joint.axis_W), joint.axis_W);
  return to_vector6(joint.axis_W, Vector3d::Zero());
}

hydro::BodyState project_onto_joint(const ReducedJoint& joint, hydro::BodyState state) {
  const hydro::BodyState& start = joint.initial;
  if (joint.type == Type::fixed) return project_onto_locks(kAllDofs, start, state);
  const Vector3d& e = joint.axis_W;
  if (!joint.turns()) {
    state.orientation = start.orientation;
    state.position = start.position + e.dot(state.position - start.position) * e;
    state.linear_velocity = e.dot(state.linear_velocity) * e;
    state.angular_velocity.setZero();
    return state;
  }
  if (joint.type == Type::hinge) {
    state.orientation =
        twist(state.orientation * start.orientation.conjugate(), e) * start.orientation;
    state.angular_velocity = e.dot(state.angular_velocity) * e;
  }
  const Vector3d r = state.orientation * joint.anchor_B;
  state.position = joint.anchor_W - r;
  state.linear_velocity = r.cross(state.angular_velocity);
  return state;
}

hydro::BodyState advance_on_joint(const ReducedJoint& joint, const Matrix6d& inertia_B,
                                  hydro::BodyState state, double time, const Vector3d& rotors_B) {
  if (joint.type == Type::ball) {
    const Subspace N_B = turning_about(joint.anchor_B);
    return project_onto_joint(
        joint, rotated_freely(N_B.transpose() * inertia_B * N_B, state, time, rotors_B));
  }
  state.position += time * state.linear_velocity;
  state.orientation = exponential(time * state.angular_velocity) * state.orientation;
  return project_onto_joint(joint, state);
}

}  // namespace engine
