#include "engine/guide.h"

#include "engine/free_motion.h"
#include "engine/locks.h"

namespace engine {
namespace {

/// True if a joint holds the body, and nothing that could move at its other end.
bool holds_to_the_world(const JointSpec& joint, const SimulationSpec& spec, BodyId body) {
  const BodyId other = joint.first == body ? joint.second : joint.first;
  return other == kWorld || immovable(spec.bodies[static_cast<std::size_t>(other)].locked);
}

/// q' of the state's velocity.
double rate(const Guide& guide, const hydro::BodyState& state) {
  return guide.axis_W.dot(guide.turns ? state.angular_velocity : state.linear_velocity);
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
  if (!only || in_current || partly_held(body.locked) || !holds_to_the_world(*only, spec, id) ||
      (only->type != JointSpec::Type::hinge && only->type != JointSpec::Type::slider))
    return std::nullopt;
  return Guide{.turns = only->type == JointSpec::Type::hinge,
               .anchor_W = only->anchor_W,
               .axis_W = only->axis_W,
               .initial = body.initial};
}

Vector6d direction(const Guide& guide, const hydro::BodyState& state) {
  if (!guide.turns) return stacked(guide.axis_W, Eigen::Vector3d::Zero());
  return stacked(guide.axis_W.cross(state.position - guide.anchor_W), guide.axis_W);
}

hydro::BodyState guided(const Guide& guide, hydro::BodyState state) {
  const hydro::BodyState& start = guide.initial;
  const double q_rate = rate(guide, state);
  if (guide.turns) {
    const Eigen::Quaterniond turn =
        twist(state.orientation * start.orientation.conjugate(), guide.axis_W);
    state.orientation = turn * start.orientation;
    state.position = guide.anchor_W + turn * (start.position - guide.anchor_W);
  } else {
    state.orientation = start.orientation;
    state.position =
        start.position + guide.axis_W.dot(state.position - start.position) * guide.axis_W;
  }
  return with_velocity(state, q_rate * direction(guide, state), Eigen::Vector3d::Zero());
}

hydro::BodyState slid(const Guide& guide, hydro::BodyState state, double time) {
  const Eigen::Vector3d way = time * rate(guide, state) * guide.axis_W;
  if (guide.turns)
    state.orientation = exponential(way) * state.orientation;
  else
    state.position += way;
  return guided(guide, state);
}

}  // namespace engine
