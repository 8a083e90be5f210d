#include "engine/guide.h"

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

bool can_guide(Type type) {
  return type == Type::hinge || type == Type::slider || type == Type::ball;
}

/// N of a body that turns about a point `r` away from its centre of mass, in the axes of r.
Ways turning_about(const Vector3d& r) {
  Ways N(6, 3);
  for (int i = 0; i < 3; ++i) N.col(i) = stacked(Vector3d::Unit(i).cross(-r), Vector3d::Unit(i));
  return N;
}

/// From the centre of mass to the anchor, body axes.
Vector3d anchor_B(const Guide& guide) {
  return guide.initial.orientation.conjugate() * Vector3d(guide.anchor_W - guide.initial.position);
}

}  // namespace

std::optional<Guide> find_guide(const SimulationSpec& spec, std::size_t index) {
  const BodySpec& body = spec.bodies[index];
  const auto id = static_cast<BodyId>(index);
  const JointSpec* only = nullptr;
  for (const JointSpec& joint : spec.joints) {
    if (joint.first != id && joint.second != id) continue;
    if (only) return std::nullopt;
    only = &joint;
  }
  const bool in_current = spec.sea && body.added_mass && !spec.sea->current.isZero(0);
  if (!only || in_current || partly_held(body.locked) || !can_guide(only->type) ||
      !holds_to_the_world(*only, spec, id))
    return std::nullopt;
  return Guide{.type = only->type,
               .anchor_W = only->anchor_W,
               .axis_W = only->axis_W,
               .initial = body.initial};
}

Ways ways(const Guide& guide, const hydro::BodyState& state) {
  const Vector3d r = guide.anchor_W - state.position;
  if (guide.type == Type::ball) return turning_about(r);
  if (guide.type == Type::hinge) return stacked(r.cross(guide.axis_W), guide.axis_W);
  return stacked(guide.axis_W, Vector3d::Zero());
}

hydro::BodyState guided(const Guide& guide, hydro::BodyState state) {
  const hydro::BodyState& start = guide.initial;
  const Vector3d& e = guide.axis_W;
  if (!guide.turns()) {
    state.orientation = start.orientation;
    state.position = start.position + e.dot(state.position - start.position) * e;
    state.linear_velocity = e.dot(state.linear_velocity) * e;
    state.angular_velocity.setZero();
    return state;
  }
  if (guide.type == Type::hinge) {
    state.orientation =
        twist(state.orientation * start.orientation.conjugate(), e) * start.orientation;
    state.angular_velocity = e.dot(state.angular_velocity) * e;
  }
  const Vector3d r = state.orientation * anchor_B(guide);
  state.position = guide.anchor_W - r;
  state.linear_velocity = r.cross(state.angular_velocity);
  return state;
}

hydro::BodyState slid(const Guide& guide, const Matrix6d& inertia_B, hydro::BodyState state,
                      double time) {
  if (guide.type == Type::ball) {
    const Ways N_B = turning_about(anchor_B(guide));
    return guided(guide, turned_freely(N_B.transpose() * inertia_B * N_B, state, time));
  }
  state.position += time * state.linear_velocity;
  state.orientation = exponential(time * state.angular_velocity) * state.orientation;
  return guided(guide, state);
}

}  // namespace engine
