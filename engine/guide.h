#pragma once

#include <optional>

#include "engine/six.h"
#include "engine/spec.h"

/// @file
/// A joint that leaves a body one way to go: a hinge or a slider to what cannot move.
///
/// Its coordinate q is an angle [rad] or a length [m]: the pose is that of the start turned by q
/// about the axis, or moved by q along it, and the velocity
///
///     u = n q',   n = (e × (x − p), e) of a hinge along e through p,   n = (e, 0) of a slider. (1)
///
/// The inertia along n, n·(M + A) n, is constant where A moves with the body, so that without loads
/// q' is constant: in water at rest, or without A. There a body on a guide takes the step of a free
/// one (free_step.h) in its one degree of freedom: of second order or better, without a constraint
/// to solve, and never off its joint.

namespace engine {

struct Guide {
  bool turns = true;  ///< A hinge; false: a slider.
  Eigen::Vector3d anchor_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_W = Eigen::Vector3d::UnitZ();  ///< Unit.
  hydro::BodyState initial;                           ///< q = 0.
};

/// The guide of a body that one such joint holds and nothing else does; none if (1) moves on by
/// itself, as a body with added mass in a current does.
std::optional<Guide> find_guide(const SimulationSpec& spec, std::size_t body);

/// n of (1), in W.
Vector6d direction(const Guide& guide, const hydro::BodyState& state);

/// The nearest state on the guide, its velocity by q' of a hinge's turning or a slider's motion.
hydro::BodyState guided(const Guide& guide, hydro::BodyState state);

/// The same after `time` [s] of motion without loads.
hydro::BodyState slid(const Guide& guide, hydro::BodyState state, double time);

}  // namespace engine
