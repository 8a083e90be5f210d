#pragma once

#include <optional>

#include "engine/motion/added_inertia.h"

/// @file
/// A hinge, slider, ball or fixed joint to something immovable, solved in the coordinates of the
/// joint.
///
/// The velocity about the centre of mass x is u = N q', with the rates q' of the joint:
///
///     hinge along e through p    N = (e × (x − p), e)          q: angle
///     slider along e             N = (e, 0)                    q: length                   (E10)
///     ball joint at p            N = (−[x − p]×, 1)            q: turn about p, in W
///     fixed joint                N has no column               there is no q
///
/// Where A moves with the body so does Nᵀ (M + A) N. Without loads q' is then constant on a hinge
/// or slider, and on a ball joint obeys Euler's equations of a body with that inertia: in water at
/// rest, or without A. Such a body takes the substeps of a free one with the mobility N: they are
/// of second order or better, need no constraint solver, and never leave the joint.

namespace engine {

struct ReducedJoint {
  JointSpec::Type type = JointSpec::Type::hinge;  ///< Any but a universal joint.
  Eigen::Vector3d anchor_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_W = Eigen::Vector3d::UnitZ();   ///< Unit.
  hydro::BodyState initial;                            ///< On the joint.
  Eigen::Vector3d anchor_B = Eigen::Vector3d::Zero();  ///< From the centre of mass.

  bool turns() const { return type == JointSpec::Type::hinge || type == JointSpec::Type::ball; }
};

/// The reduced joint of a body that one such joint and no lock constrains. There is none for added
/// mass in a current, where q' is not constant without loads. A fixed joint is one in a current and
/// beside locks, too: it leaves no q'.
std::optional<ReducedJoint> find_reduced_joint(const SimulationSpec& spec, std::size_t body);

/// N of (E10), in W.
Subspace motion_subspace(const ReducedJoint& joint, const hydro::BodyState& state);

/// The nearest state on the joint; q' is taken from the angular velocity or, on a slider, from the
/// linear one.
hydro::BodyState project_onto_joint(const ReducedJoint& joint, hydro::BodyState state);

/// The state on the joint after `time` [s] without loads.
/// @param inertia_B   M + A about the centre of mass, body axes.
/// @param rotors_B    H of (E1).
hydro::BodyState advance_on_joint(const ReducedJoint& joint, const Matrix6d& inertia_B,
                                  hydro::BodyState state, double time,
                                  const Eigen::Vector3d& rotors_B = Eigen::Vector3d::Zero());

}  // namespace engine
