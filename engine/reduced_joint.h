#pragma once

#include <optional>

#include "engine/added_inertia.h"
#include "engine/spec.h"

/// @file
/// A joint to what cannot move: a hinge, a slider or a ball joint that a body can follow by itself.
///
/// The velocity about the centre of mass x is u = N q', with the rates q' of the ways that are
/// left:
///
///     hinge along e through p    N = (e × (x − p), e)          the angle
///     slider along e             N = (e, 0)                    the length                    (E10)
///     ball joint at p            N = (−[x − p]×, 1)            the turn about p, in W
///
/// Where A moves with the body so does Nᵀ (M + A) N. Without loads q' is then constant on a hinge
/// or slider, and on a ball joint follows Euler's equations of a body with that inertia: in water
/// at rest, or without A. There a project_onto_joint body takes the step of a free one
/// (free_step.h) in the ways left to it: of second order or better, without a constraint to solve,
/// and never off its joint.

namespace engine {

struct ReducedJoint {
  JointSpec::Type type = JointSpec::Type::hinge;  ///< Hinge, slider or ball.
  Eigen::Vector3d anchor_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_W = Eigen::Vector3d::UnitZ();  ///< Unit.
  hydro::BodyState initial;                           ///< On the joint.

  bool turns() const { return type != JointSpec::Type::slider; }
};

/// The reduced_joint of a body that one such joint holds and nothing else does; none if u moves on
/// by itself in another way, as that of a body with added mass in a current does.
std::optional<ReducedJoint> find_reduced_joint(const SimulationSpec& spec, std::size_t body);

/// N of (E10), in W.
Subspace motion_subspace(const ReducedJoint& reduced_joint, const hydro::BodyState& state);

/// The nearest state on the reduced_joint, its velocity by q' of the state's turning or, on a
/// slider, motion.
hydro::BodyState project_onto_joint(const ReducedJoint& reduced_joint, hydro::BodyState state);

/// The same after `time` [s] of motion without loads.
/// @param inertia_B   M + A about the centre of mass, body axes.
hydro::BodyState advance_on_joint(const ReducedJoint& reduced_joint, const Matrix6d& inertia_B,
                                  hydro::BodyState state, double time);

}  // namespace engine
