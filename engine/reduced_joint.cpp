#include "engine/reduced_joint.h"

#include "engine/free_motion.h"
#include "engine/locks.h"

namespace engine {
namespace {

using Eigen::Vector3d;
using Type = JointSpec::Type;

/// True if a joint holds the body, and nothing that could move at its other end.
bool holds_to_the_world(const JointSpec& joint, const SimulationSpec& spec, BodyId body) {
  const BodyId other = joint.first == body ? joint.second : joint.first;
  return other == kWorld || immovable(spec.bodies[static_cast<std::size_t>(other)].locked);
}

bool can_be_reduced(Type type) {
  return type == Type::hinge || type == Type::slider || type == Type::ball;
}

/// N of a body that turns about a point `r` away from its centre of mass, in the axes of r.
Subspace turning_about(const Vector3d& r) {
  Subspace N(6, 3);
  for (int i = 0; i < 3; ++i) N.col(i) = to_vector6(Vector3d::Unit(i).cross(-r), Vector3d::Unit(i));
  return N;
}

/// From the centre of mass to the anchor, body axes.
Vector3d anchor_B(const ReducedJoint& reduced_joint) {
  return reduced_joint.initial.orientation.conjugate() *
         Vector3d(reduced_joint.anchor_W - reduced_joint.initial.position);
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
  const bool in_current = spec.sea && body.added_mass && !spec.sea->current.isZero(0);
  if (!only || in_current || partly_locked(body.locked) || !can_be_reduced(only->type) ||
      !holds_to_the_world(*only, spec, id))
    return std::nullopt;
  return ReducedJoint{.type = only->type,
                      .anchor_W = only->anchor_W,
                      .axis_W = only->axis_W,
                      .initial = body.initial};
}

Subspace motion_subspace(const ReducedJoint& reduced_joint, const hydro::BodyState& state) {
  const Vector3d r = reduced_joint.anchor_W - state.position;
  if (reduced_joint.type == Type::ball) return turning_about(r);
  if (reduced_joint.type == Type::hinge)
    return to_vector6(r.cross(reduced_joint.axis_W), reduced_joint.axis_W);
  return to_vector6(reduced_joint.axis_W, Vector3d::Zero());
}

hydro::BodyState project_onto_joint(const ReducedJoint& reduced_joint, hydro::BodyState state) {
  const hydro::BodyState& start = reduced_joint.initial;
  const Vector3d& e = reduced_joint.axis_W;
  if (!reduced_joint.turns()) {
    state.orientation = start.orientation;
    state.position = start.position + e.dot(state.position - start.position) * e;
    state.linear_velocity = e.dot(state.linear_velocity) * e;
    state.angular_velocity.setZero();
    return state;
  }
  if (reduced_joint.type == Type::hinge) {
    state.orientation =
        twist(state.orientation * start.orientation.conjugate(), e) * start.orientation;
    state.angular_velocity = e.dot(state.angular_velocity) * e;
  }
  const Vector3d r = state.orientation * anchor_B(reduced_joint);
  state.position = reduced_joint.anchor_W - r;
  state.linear_velocity = r.cross(state.angular_velocity);
  return state;
}

hydro::BodyState advance_on_joint(const ReducedJoint& reduced_joint, const Matrix6d& inertia_B,
                                  hydro::BodyState state, double time) {
  if (reduced_joint.type == Type::ball) {
    const Subspace N_B = turning_about(anchor_B(reduced_joint));
    return project_onto_joint(reduced_joint,
                              turned_freely(N_B.transpose() * inertia_B * N_B, state, time));
  }
  state.position += time * state.linear_velocity;
  state.orientation = exponential(time * state.angular_velocity) * state.orientation;
  return project_onto_joint(reduced_joint, state);
}

}  // namespace engine
